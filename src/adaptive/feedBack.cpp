#include "adaptive/feedBack.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace sw {
namespace {

/// What an audit says about a block.
struct BlockSums {
    double looks = 0;
    double products = 0;
    double coverage = 0;  ///< times product

    void add(const BlockSums& other) {
        looks += other.looks;
        products += other.products;
        coverage += other.coverage;
    }
    void add(const AuditedPixel& found) {
        const double product = static_cast<double>(std::max(found.product, 0.f));
        products += product;
        coverage += product * static_cast<double>(found.coverage);
    }
    double squaredError() const { return looks > 0 ? products / looks : 0; }
    double meanCoverage() const { return std::clamp(coverage / products, 0.02, 0.9); }
};

// Samples after which details should be found that cover a share of a pixel: each sample that hits
// none leaves 1 - share of them.
int samplesFor(double squaredError, double coverage, double limit) {
    int samples = 4;
    while (squaredError * std::pow(1 - coverage, samples - 1) > limit && samples < 4096)
        samples *= 2;
    return samples;
}

}  // namespace

double repair(AdaptiveGrid& grid, const Audit& audit, const Window& window, bool spread) {
    double taken = 0;
    for (const AuditedPixel& found : audit.wrong()) {
        const bool counts = found.x >= window.x0 && found.x < window.x1 && found.y >= window.y0 &&
                            found.y < window.y1;
        if (counts) taken += static_cast<double>(found.change);
    }
    grid.replace(audit.wrong(), spread);
    return taken / window.width() / window.height();
}

bool doubtBlocks(AdaptiveGrid& grid, const Audit& audit, double share, const Window& region,
                 float tolerance) {
    std::vector<BlockSums> sums(grid.unseen.count());
    forEachPixel(region, [&](int x, int y) {
        sums[grid.unseen.indexOf(x, y)].looks += audit.isLookedAt(x, y, share);
    });
    for (const AuditedPixel& found : audit.wrong())
        sums[grid.unseen.indexOf(found.x, found.y)].add(found);

    const double limit = static_cast<double>(tolerance) * static_cast<double>(tolerance);
    bool any = false;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        BlockSums around;
        grid.unseen.forEachAround(i, [&](std::size_t k) { around.add(sums[k]); });
        const double error = std::max(sums[i].squaredError(), around.squaredError());
        if (!(error > limit)) continue;
        const int samples = samplesFor(error, around.meanCoverage(), limit);
        grid.unseen.set(i, {static_cast<float>(error), samples - 1});
        any = true;
    }
    return any;
}

}  // namespace sw
