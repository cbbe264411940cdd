#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "adaptive/adaptivePixel.h"
#include "swRenderer.h"

namespace sw {

/// What an audit has found that pixels without visible detail have missed, in blocks of the whole
/// picture: a block is the same in every window.
class UnseenDetail {
public:
    static constexpr int side = 32;  ///< of a block, in pixels

    /// The error that a pixel may have in a block, and the samples of the pixels that may have it.
    struct Block {
        float squaredError = 0;
        int samples = 0;  ///< at most
    };

    explicit UnseenDetail(const Window& region)
        : left(region.x0 / side),
          top(region.y0 / side),
          columns((region.x1 - 1) / side - left + 1),
          rows((region.y1 - 1) / side - top + 1),
          blocks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    std::size_t count() const { return blocks.size(); }
    std::size_t indexOf(int x, int y) const {
        return static_cast<std::size_t>(y / side - top) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(x / side - left);
    }
    /// Calls function(index) for a block and those around it.
    template <typename Function>
    void forEachAround(std::size_t i, const Function& function) const {
        const int column = static_cast<int>(i) % columns, row = static_cast<int>(i) / columns;
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, rows - 1); ++y)
            for (int x = std::max(column - 1, 0); x <= std::min(column + 1, columns - 1); ++x)
                function(static_cast<std::size_t>(y * columns + x));
    }
    void set(std::size_t i, const Block& block) {
        blocks[i] = block;
        isEmpty = false;
    }
    void setAll(const Block& block) {
        std::fill(blocks.begin(), blocks.end(), block);
        isEmpty = !(block.squaredError > 0);
    }
    /// RMS error up to which a pixel is flat. Samples that differ by eight times that make no flat
    /// pixel, however many there are.
    float flatLimit = 0;
    bool isFlat(const AdaptivePixel& pixel, float squaredError) const {
        const float limit = flatLimit * flatLimit;
        return squaredError <= limit && pixel.contrast <= 64 * limit;
    }

    /// What a pixel may have missed.
    /// @param seen  its squared error as its samples know it
    float squaredError(int x, int y, const AdaptivePixel& pixel, float seen) const {
        if (isEmpty) return 0;
        const Block& block = blocks[indexOf(x, y)];
        return pixel.samples <= block.samples && isFlat(pixel, seen) ? block.squaredError : 0;
    }

private:
    int left, top, columns, rows;
    std::vector<Block> blocks;
    bool isEmpty = true;
};

}  // namespace sw
