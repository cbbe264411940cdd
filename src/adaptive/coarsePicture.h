#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "adaptive/adaptivePixel.h"
#include "adaptive/timeShare.h"
#include "swRenderer.h"
#include "swZeroMemory.h"

namespace sw {

/// A picture in square blocks, each of the colour of one pixel in its middle. It is made in little
/// time, and stands in for the pixels that there is no time for. First come some 64 blocks, then
/// level after level, each with blocks of half the side.
class CoarsePicture {
public:
    /// @param region  the others must outlive this
    CoarsePicture(const Window& region, const RadianceAt& radiance, const RenderOptions& options);

    /// Samples the next level. What is missing of it when time is up shows the level before.
    void addLevel(TimeShare& share);
    /// Hands all pixels to the preview, if there is one.
    void show() const;

    /// Side of the last level's blocks, in pixels; 0 before there is any.
    int side() const { return finer.side; }
    /// How many pixels were sampled in the last level.
    std::uint64_t samplesOfLevel() const { return ofLevel; }
    std::uint64_t samples() const { return taken; }
    const RayCount& rays() const { return traced; }
    int threads() const { return mostThreads; }

    struct Block {
        Color color;
        bool isKnown = false;
        bool isCut = false;  ///< its sample's rays were cut short

        bool isWhole() const { return isKnown && !isCut; }
    };
    /// The smallest block with a colour that has this pixel.
    const Block& at(int x, int y) const;
    /// How many pixels of a row, from x on, have the same block.
    int runFrom(int x) const;
    /// Whether the pixel's own colour was sampled.
    bool isSampled(int x, int y) const { return finer.side == 1 && finer.at(x, y).isWhole(); }
    /// Expected square of the error, as displayed, if the pixel takes that block's colour.
    float squaredErrorAt(int x, int y) const;
    /// Whether all blocks around were cut: then a pixel here will take too long as well.
    bool takesLong(int x, int y) const { return finer.areCutAround(x, y); }

private:
    struct Level {
        Window region;
        int side = 0;   // a power of 2 ...
        int shift = 0;  // ... and its logarithm
        int columns = 0, rows = 0;
        std::vector<Block, ZeroMemory<Block>> blocks;

        Level() = default;
        Level(const Window& region, int side);
        const Block& at(int x, int y) const;
        Block& at(int x, int y);
        bool areCutAround(int x, int y) const;
    };
    void spreadColors();
    void sample(int column, int row);
    int sideAt(int x, int y) const;

    const Window region;
    const RadianceAt& radiance;
    const RenderOptions& options;
    Level coarser, finer;  // the coarser one is finished
    std::atomic<std::uint64_t> ofLevel{0};
    std::uint64_t taken = 0;
    RayCount traced;
    int mostThreads = 0;
};

}  // namespace sw
