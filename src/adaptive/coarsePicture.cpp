#include "adaptive/coarsePicture.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "adaptive/tiles.h"

namespace sw {
namespace {

constexpr int firstBlocks = 8;  // per side of the picture, at most

int firstSide(const Window& region) {
    int side = 1;
    while (firstBlocks * side < std::max(region.width(), region.height())) side *= 2;
    return side;
}

Color displayed(const Color& c) {
    return {clampToDisplay(c[0]), clampToDisplay(c[1]), clampToDisplay(c[2])};
}

}  // namespace

CoarsePicture::Level::Level(const Window& region, int side)
    : region(region),
      side(side),
      shift(std::countr_zero(static_cast<unsigned>(side))),
      columns((region.width() + side - 1) / side),
      rows((region.height() + side - 1) / side),
      blocks(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

const CoarsePicture::Block& CoarsePicture::Level::at(int x, int y) const {
    const auto column = static_cast<std::size_t>((x - region.x0) >> shift);
    const auto row = static_cast<std::size_t>((y - region.y0) >> shift);
    return blocks[row * static_cast<std::size_t>(columns) + column];
}

CoarsePicture::Block& CoarsePicture::Level::at(int x, int y) {
    return const_cast<Block&>(std::as_const(*this).at(x, y));
}

bool CoarsePicture::Level::areCutAround(int x, int y) const {
    if (!at(x, y).isCut) return false;
    bool all = true;
    forEachPixel({-1, -1, 2, 2}, [&](int i, int j) {
        all = all && at(std::clamp(x + i * side, region.x0, region.x1 - 1),
                        std::clamp(y + j * side, region.y0, region.y1 - 1))
                         .isCut;
    });
    return all;
}

CoarsePicture::CoarsePicture(const Window& region, const RadianceAt& radiance,
                             const RenderOptions& options)
    : region(region), radiance(radiance), options(options) {}

void CoarsePicture::addLevel(TimeShare& share) {
    const int side = finer.side == 0 ? firstSide(region) : finer.side / 2;
    coarser = std::move(finer);
    finer = Level(region, side);
    ofLevel = 0;

    RenderOptions how = options;
    how.tileSize = std::clamp(std::max(finer.columns, finer.rows) / firstBlocks, 1, 16);
    const auto takesLong = [this](int column, int row) {
        return coarser.side > 0 &&
               coarser.areCutAround(region.x0 + column * finer.side, region.y0 + row * finer.side);
    };
    const Sweep sweep = forEachTile({0, 0, finer.columns, finer.rows}, how, [&](const Window& t) {
        visit(
            t, share, [this](int column, int row) { sample(column, row); }, takesLong);
    });
    traced += sweep.rays;
    mostThreads = std::max(mostThreads, sweep.threads);
    taken += ofLevel;
    if (coarser.side == 0) spreadColors();
}

void CoarsePicture::show() const {
    if (options.preview) options.preview(region, [this](int x, int y) { return at(x, y).color; });
}

void CoarsePicture::sample(int column, int row) {
    const int x = std::min(region.x0 + column * finer.side + finer.side / 2, region.x1 - 1);
    const int y = std::min(region.y0 + row * finer.side + finer.side / 2, region.y1 - 1);
    checkStop(x, y, 1);
    AdaptivePixel pixel;
    sw::refine(pixel, x, y, radiance, options.seed);
    finer.at(x, y) = {pixel.mean, true, ShortRays::areOn()};
    ofLevel.fetch_add(1, std::memory_order_relaxed);
}

// At the first level, blocks without a colour take one from beside them.
void CoarsePicture::spreadColors() {
    for (int i = 0; i < 2 * firstBlocks; ++i) {
        const Level before = finer;
        forEachPixel({0, 0, finer.columns, finer.rows}, [&](int column, int row) {
            const int x = region.x0 + column * finer.side, y = region.y0 + row * finer.side;
            Block& block = finer.at(x, y);
            forEachPixel({-1, -1, 2, 2}, [&](int dx, int dy) {
                const Block& other =
                    before.at(std::clamp(x + dx * finer.side, region.x0, region.x1 - 1),
                              std::clamp(y + dy * finer.side, region.y0, region.y1 - 1));
                if (!block.isKnown && other.isKnown) block = {other.color, true, true};
            });
        });
    }
}

const CoarsePicture::Block& CoarsePicture::at(int x, int y) const {
    const Block& block = finer.at(x, y);
    return block.isKnown || coarser.side == 0 ? block : coarser.at(x, y);
}

int CoarsePicture::sideAt(int x, int y) const {
    return finer.at(x, y).isKnown || coarser.side == 0 ? finer.side : coarser.side;
}

int CoarsePicture::runFrom(int x) const {
    // A block that is missing ends where the next finer one begins, which may be known.
    return finer.side - ((x - region.x0) & (finer.side - 1));
}

// An edge of random place and direction separates two points with a chance proportional to their
// distance. From a place in the block to its middle, that is about half of what it is from one
// block's middle to the next one's.
float CoarsePicture::squaredErrorAt(int x, int y) const {
    const int step = sideAt(x, y);
    const Color own = displayed(at(x, y).color);
    float sum = 0;
    for (const auto& [i, j] : {std::pair(-step, 0), {step, 0}, {0, -step}, {0, step}})
        sum += square(own - displayed(at(std::clamp(x + i, region.x0, region.x1 - 1),
                                         std::clamp(y + j, region.y0, region.y1 - 1))
                                          .color));
    return sum / 8;
}

}  // namespace sw
