#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "tools/bench/models.h"

namespace bench {

/// A model in Intel's Embree: single rays, default build quality.
class Yardstick {
public:
    virtual ~Yardstick() = default;

    /// Builds the tree, with one thread.
    virtual void build() = 0;
    /// How many of the rays hit something.
    virtual std::size_t trace(std::span<const sw::Ray> rays, bool any) const = 0;
    /// Memory for tree and geometry.
    virtual std::size_t bytes() const = 0;
};

/// @param watertight  its robust mode: no ray slips between two triangles
/// @return            null if Embree is not installed
std::unique_ptr<Yardstick> makeYardstick(const Model& model, bool watertight);

}  // namespace bench
