#pragma once

#include <array>

#include "app/explore/rayColumns.h"
#include "swNff.h"

/// Shapes as columns of numbers: line in the scene file, number of its material, kind, and what
/// describes the kind:
///
///     0 sphere          centre, radius
///     1 triangle, patch three corners
///     2 cone            base, its radius, apex, its radius
///     3 others          the corners of a box that holds them
struct ShapeColumns {
    explicit ShapeColumns(const std::vector<sw::NffShape>& shapes);

    std::array<Column, 4> columns{
        {{"kind", 1, {}}, {"line", 4, {}}, {"material", 4, {}}, {"geometry", 4, {}}}};
    std::vector<sw::Material> materials;  ///< all that differ

private:
    std::uint32_t numberOf(const sw::Material& material);
};
