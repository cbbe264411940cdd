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

// Many shapes of one type as the leaves of a tree: blocks of one to eight neighbours. Memory
// decides how fast a large scene is, so of a sphere or triangle only coordinates and the number of
// its material are kept, like coordinates of a block side by side.

namespace sw {

/// The materials of many shapes, those alike only once.
struct MaterialTable {
    std::vector<Material> materials;
    std::vector<std::uint32_t> numbers;  ///< one per shape

    const Material& of(std::size_t shape) const { return materials[numbers[shape]]; }
};

class SphereBlocks {
public:
    static constexpr int size = 8;  ///< most shapes of a block

    /// @param order   the numbers of the spheres, block after block
    /// @param blocks  how many spheres each block holds
    void assign(std::vector<Sphere> spheres, std::span<const std::uint32_t> order,
                std::span<const int> blocks);

    /// One bit for each of the `count` spheres from place `first` on that the ray may hit. They
    /// must be one block.
    unsigned candidates(const FilterRay& ray, std::size_t first, int count) const;

    /// The i-th sphere of a block, as it was.
    Sphere shape(std::size_t first, int count, int i) const;

    /// Asks for a block that will be looked at soon.
    void prefetch(std::size_t first, int count) const;

private:
    std::vector<float> rows;  // per block: centre x, y, z, radius
    MaterialTable materials;
};

class TriangleBlocks {
public:
    static constexpr int size = 8;

    void assign(std::vector<Triangle> triangles, std::span<const std::uint32_t> order,
                std::span<const int> blocks);
    unsigned candidates(const FilterRay& ray, std::size_t first, int count) const;
    Triangle shape(std::size_t first, int count, int i) const;
    void prefetch(std::size_t first, int count) const;

private:
    std::vector<float> rows;  // per block: the vertices' x, y, z; the edges' longest component
    MaterialTable materials;
};

/// Shapes without a filter but their boxes.
template <typename Shape>
class PlainBlocks {
public:
    static constexpr int size = 1;

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
