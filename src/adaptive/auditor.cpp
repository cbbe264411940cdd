#include "adaptive/auditor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adaptive/adaptiveResult.h"
#include "adaptive/feedBack.h"

namespace sw {
namespace {

constexpr double leastShare = 0.125;  // of the flat pixels
constexpr double enoughPixels = 8192;
constexpr double mostShare = 2;       // of them, but up to ...
constexpr double alwaysPixels = 1e5;  // ... so many
constexpr double sharpness = 0.35;    // standard error of a squared error, relative to it

}  // namespace

Auditor::Auditor(AdaptiveGrid& grid, const Window& region, const Window& window, double pixels,
                 const RadianceAt& radiance, std::uint64_t seed, const ErrorLimits& limits)
    : grid(grid),
      region(region),
      window(window),
      pictureSize(pixels),
      radiance(radiance),
      seed(seed),
      limits(limits) {}

double Auditor::firstShare() const {
    return std::clamp(enoughPixels / pictureSize, leastShare, 1.0);
}

// An eighth of the error that matters.
float Auditor::flatLimit() const {
    if (limits.tolerance > 0) return limits.tolerance / 8;
    if (limits.targetRmse > 0) return limits.targetRmse / 8;
    return static_cast<float>(std::min(estimatedRmse(grid, window), 0.1)) / 8;
}

// The factor changes with the number of samples, but slowly.
std::unique_ptr<Audit> Auditor::newAudit() {
    grid.unseen.flatLimit = flatLimit();
    const double drift = rounds == 0 ? 0 : 0.1 * factor.squaredError * factor.squaredError;
    return std::make_unique<Audit>(grid, region, window, grid.unseen.flatLimit, radiance, seed,
                                   rounds++,
                                   Judgement{factor.squaredError, factor.variance + drift}, heavy);
}

void Auditor::learn(const Audit& audit) {
    factor = audit.modelFactor();
    modelSamples = grid.samples();
    grid.modelFactor = static_cast<float>(factor.squaredError);
}

void Auditor::auditModel(TimeShare& share) {
    const auto fresh = newAudit();
    fresh->lookAtBusy(share);
    audited += fresh->pixels();
    learn(*fresh);
}

void Auditor::audit(TimeShare& share, bool sharpens) {
    const auto start = Clock::now();
    auto fresh = newAudit();
    fresh->lookAtFlat(firstShare(), share);
    fresh->lookAtBusy(share);
    if (sharpens) sharpen(*fresh, share);
    audited += fresh->pixels();
    samples = grid.samples();
    took = std::chrono::duration<double>(Clock::now() - start).count();
    // Where time was too short, the audit before says more, or nothing is known.
    if (share.wasOver() && fresh->pixels() < (last ? last->pixels() / 2 : 100)) return;
    last = std::move(fresh);
    heavy = std::max(heavy, last->meanProduct());
    repaired = 0;
    isRepaired = false;
    learn(*last);
}

// Looks at more pixels.
void Auditor::sharpen(Audit& audit, TimeShare& share) {
    const double most = std::max(mostShare, alwaysPixels / pictureSize);
    for (double looked = firstShare(); looked < most && !share.wasOver() && !isSharp(audit);) {
        const double next = std::min(2 * looked, most);
        audit.lookAtMore(looked, next, share);
        looked = next;
    }
}

// Nothing found is sharp enough, and so is an error that is much too large.
bool Auditor::isSharp(const Audit& audit) const {
    const double sum = audit.unseen().squaredError + audit.seen().squaredError;
    const double target = static_cast<double>(limits.targetRmse);
    if ((!audit.hasFound() && heavy == 0) || (target > 0 && sum > 2 * target * target)) return true;
    return audit.varianceWithHeavy() <= sharpness * sharpness * sum * sum;
}

bool Auditor::feedBackByBlocks(TimeShare& share) {
    const bool any = doubtBlocks(grid, *last, firstShare(), region, limits.tolerance);
    if (!any) {
        audited -= last->pixels();
        sharpen(*last, share);
        audited += last->pixels();
    }
    repairAll(true);
    return any;
}

// Once: later, the pixels may be better still.
void Auditor::repairAll(bool spread) {
    if (!isRepaired) repaired += repair(grid, *last, window, spread);
    isRepaired = true;
}

void Auditor::feedBack() {
    grid.unseen.setAll({static_cast<float>(last->unseenPerPixel()), last->medianSamplesOfFlat()});
    repairAll(true);
}

void Auditor::settle(bool repairs) {
    const double before = last->unseen().squaredError;
    if (repairs) repairAll(false);
    double flat = 0;
    forEachPixel(window, [&](int x, int y) { flat += grid.isFlat(x, y); });
    if (flat == 0) return grid.unseen.setAll({});
    const double left = std::max(before - repaired, 0.0) * window.width() * window.height();
    grid.unseen.setAll({static_cast<float>(left / flat), std::numeric_limits<int>::max()});
}

Judgement Auditor::found() const {
    return {last->seen().squaredError + last->unseen().squaredError,
            last->seen().variance + last->unseen().variance};
}

double Auditor::sway() const {
    return std::sqrt(last->seen().variance + last->varianceOfFinds());
}

}  // namespace sw
