#pragma once

#include <string>
#include <vector>

#include "swNff.h"

namespace rayTree {

/// Tells which shape of a scene file a ray hit, which the hit itself does not know.
class ShapeNames {
public:
    explicit ShapeNames(std::vector<sw::NffShape> all) : shapes(std::move(all)) {}

    /// "sphere (line 12, centre (0, 1, 0), radius 2)" for example.
    /// @param hit  what the scene says about the ray
    std::string hitBy(const sw::Ray& ray, const sw::Intersection& hit) const;

    /// Shapes that claim a hit at t = NaN, which no scene counts: one for each.
    std::vector<std::string> hitNowhere(const sw::Ray& ray) const;

private:
    std::vector<sw::NffShape> shapes;
};

}  // namespace rayTree
