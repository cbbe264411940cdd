#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "accel/filterRay.h"
#include "accel/simd.h"
#include "swSphere.h"
#include "swTriangle.h"

// Many shapes of one type as the leaves of a tree, one to eight neighbours in each. Memory decides
// how fast a large scene is. So only the coordinates of a sphere or triangle and the number of its
// material are kept, and within a leaf the x of all shapes come first, then the y, and so on.

namespace sw {

/// The materials of many shapes; equal ones are kept once.
struct MaterialTable {
    std::vector<Material> materials;
    std::vector<std::uint32_t> numbers;  ///< one per shape

    const Material& of(std::size_t shape) const { return materials[numbers[shape]]; }
};

class SphereLeaves {
public:
    static constexpr int leafSize = 8;  ///< most shapes per leaf

    /// @param order  the numbers of the spheres, leaf after leaf
    /// @param sizes  how many spheres each leaf holds
    void assign(std::vector<Sphere> spheres, std::span<const std::uint32_t> order,
                std::span<const int> sizes);

    /// One bit for each sphere of a leaf that the ray may hit.
    /// @param first  the leaf's first place in the order
    /// @param count  how many spheres the leaf holds
    unsigned candidates(const FilterRay& ray, std::size_t first, int count) const;

    /// The i-th sphere of a leaf, as it was.
    Sphere shape(std::size_t first, int count, int i) const;

    /// Fetches a leaf's memory ahead of its use.
    void prefetch(std::size_t first, int count) const;

private:
    std::vector<float> rows;  // per leaf: centre x, y, z, radius
    MaterialTable materials;
};

class TriangleLeaves {
public:
    static constexpr int leafSize = 8;

    void assign(std::vector<Triangle> triangles, std::span<const std::uint32_t> order,
                std::span<const int> sizes);
    unsigned candidates(const FilterRay& ray, std::size_t first, int count) const;
    Triangle shape(std::size_t first, int count, int i) const;
    void prefetch(std::size_t first, int count) const;

private:
    std::vector<float> rows;  // per leaf: the vertices' x, y, z; the edges' longest component
    MaterialTable materials;
};

/// Shapes without a filter other than their boxes.
template <typename Shape>
class PlainLeaves {
public:
    static constexpr int leafSize = 1;

    void assign(std::vector<Shape> all, std::span<const std::uint32_t> order,
                std::span<const int>) {
        shapes.clear();
        for (const std::uint32_t i : order) shapes.push_back(std::move(all[i]));
    }
    unsigned candidates(const FilterRay&, std::size_t, int count) const {
        return (1u << count) - 1;
    }
    const Shape& shape(std::size_t first, int, int i) const {
        return shapes[first + static_cast<std::size_t>(i)];
    }
    void prefetch(std::size_t first, int count) const {
        simd::prefetch(&shapes[first], static_cast<std::size_t>(count) * sizeof(Shape));
    }

private:
    std::vector<Shape> shapes;
};

}  // namespace sw
