#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "rayTree/rayTree.h"

/// One number of every ray that has it, in the order of the rays.
struct Column {
    const char* name;
    int bytes;  ///< of each number
    std::vector<std::uint32_t> values;

    bool isShape() const { return std::string_view(name).ends_with("hape"); }
};

/// The rays behind many pixels as columns of numbers: at most 24 bytes a ray. Rays come in the
/// order in which they were cast, a parent before its children. page.js reads what is written here.
///
///     head   kind (3 bits), 8: hit, 16: front, 32: traced, 64: has children, 128: last of its
///     parent light  of a ray that is not traced: the light's number from 1, 0: none shape  that
///     was hit: its number in the page's list from 1, 0: unknown
///
/// The first ray of a pixel has its distance, the others the share of the way to the light (shadow
/// rays) or the point hit; if they hit nothing, their unit direction.
class RayColumns {
public:
    RayColumns();

    /// The number of the shape that a ray hit, from 1; 0: unknown.
    using ShapeOf = std::function<std::uint32_t(const sw::Ray&, const sw::Intersection&)>;

    /// Adds the rays of the next pixel.
    void add(const rayTree::RayTree& tree, const std::vector<sw::Light>& lights,
             const ShapeOf& shapeOf);
    /// Adds the pixels that follow.
    void append(const RayColumns& next);

    /// A ray that does not start where its parent hit.
    struct Origin {
        std::uint32_t ray;
        sw::Vec3 start;
    };
    /// What is wrong with a ray; see RayNode::faults.
    struct Fault {
        std::uint32_t ray;
        std::string text;
    };

    std::array<Column, 20> columns;
    std::vector<Origin> origins;
    std::vector<Fault> faults;
    std::uint32_t rays = 0;
    std::uint32_t pixels = 0;
    std::uint32_t endless = 0;  ///< pixels whose function did not end
    std::uint32_t deepest = 0;  ///< rays from the first to the last, at most

private:
    void put(std::size_t column, std::uint32_t value) { columns[column].values.push_back(value); }
    void putSurface(const rayTree::RayNode& node, const ShapeOf& shapeOf, std::size_t first);
    void putPlace(const rayTree::RayNode& node, const std::vector<sw::Light>& lights);
    void putNode(const rayTree::RayNode& node, const rayTree::RayNode* parent,
                 const std::vector<sw::Light>& lights, const ShapeOf& shapeOf, std::uint32_t level);
};
