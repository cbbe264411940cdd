#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "swRay.h"
#include "swSphere.h"
#include "swTriangle.h"

// A quick look, in float and at eight shapes at a time, at which shapes a ray may hit. It errs on
// one side only: with margins for every rounding error, it never misses a shape that the exact
// kernel would hit. What it lets through goes to Sphere::intersect or Triangle::intersect.

namespace sw {

/// A ray as the filters want it: its direction divided by a power of two, so that the largest
/// component lies in [1/2, 1). That is exact and keeps products within the range of float. NaN,
/// which lets every shape through, where the direction is too long for that.
struct FilterRay {
    float orig[3];
    float dir[3];
    float dirSquared;  ///< |dir|^2
    float minT, maxT;  ///< in units of dir
    float scale;       ///< what the true direction was divided by

    explicit FilterRay(const Ray& ray);
    /// Shortens the ray to t, in units of the true direction.
    void shorten(float t) { maxT = t * scale; }
};

/// Copies of the shapes' coordinates, in blocks of up to eight neighbours whose like coordinates
/// lie side by side.
class SphereFilter {
public:
    /// @param block  how many shapes each block holds, one block after the other; 1 to 8
    void assign(std::span<const Sphere> spheres, std::span<const int> blocks);

    /// One bit for each of the `count` spheres from `first` on that the ray may hit. They must be
    /// one block.
    unsigned candidates(const FilterRay& ray, std::size_t first, int count) const;

    std::size_t bytes() const { return rows.size() * sizeof(float); }

private:
    std::vector<float> rows;  // per block: centre x, y, z, radius
};

class TriangleFilter {
public:
    void assign(std::span<const Triangle> triangles, std::span<const int> blocks);
    unsigned candidates(const FilterRay& ray, std::size_t first, int count) const;
    std::size_t bytes() const { return rows.size() * sizeof(float); }

private:
    std::vector<float> rows;  // per block: v0 x, y, z; v1 - v0; v2 - v0; the longest component
};

}  // namespace sw
