#pragma once

#include <string>
#include <vector>

#include "swNff.h"

namespace rayTree {

/// Finds the shape of a scene file that a ray hit. The hit record does not hold it.
class ShapeNames {
public:
    explicit ShapeNames(std::vector<sw::NffShape> all) : shapes(std::move(all)) {}

    /// "sphere (line 12, centre (0, 1, 0), radius 2)" for example.
    /// @param hit  the scene's hit of the ray
    std::string hitBy(const sw::Ray& ray, const sw::Intersection& hit) const;

    /// Shapes that report a hit at t = NaN, which scenes ignore: one description each.
    std::vector<std::string> hitNowhere(const sw::Ray& ray) const;

private:
    std::vector<sw::NffShape> shapes;
};

}  // namespace rayTree
