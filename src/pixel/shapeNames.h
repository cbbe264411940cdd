#pragma once

#include <string>
#include <vector>

#include "swNff.h"

namespace pixel {

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

/// A number in six digits, the same in every locale; -0 as 0.
std::string text(float number);
/// "(1, 2, 3)".
std::string text(const sw::Vec3& v);

}  // namespace pixel
