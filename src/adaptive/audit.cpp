#include "adaptive/audit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "sampling/splitMix64.h"

namespace sw {
namespace {

constexpr auto relaxed = std::memory_order_relaxed;
constexpr double busyPixels = 280;  // that are sampled a second time, if they are cheap
constexpr int fewSamples = 16;

bool contains(const Window& window, int x, int y) {
    return x >= window.x0 && x < window.x1 && y >= window.y0 && y < window.y1;
}

// The largest squared error that a pixel may have.
double largestSquaredError(const Color& shown) {
    double sum = 0;
    for (const float channel : shown.m) {
        const double c = clampToDisplay(channel), most = std::max(c, 1 - c);
        sum += most * most;
    }
    return sum / 3;
}

double square(double value) {
    return value * value;
}

// As displayed.
double squaredDifference(const Color& a, const Color& b) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
        sum += square(static_cast<double>(clampToDisplay(a[i])) - clampToDisplay(b[i]));
    return sum / 3;
}

template <typename Pixel>
void sortByPlace(std::vector<Pixel>& pixels) {
    std::sort(pixels.begin(), pixels.end(), [](const Pixel& a, const Pixel& b) {
        return a.y < b.y || (a.y == b.y && a.x < b.x);
    });
}

}  // namespace

Audit::Audit(AdaptiveGrid& grid, const Window& region, const Window& window, float limit,
             const RadianceAt& radiance, std::uint64_t seed, int round, const Judgement& before,
             double heavy)
    : grid(grid),
      region(region),
      window(window),
      limit(limit),
      radiance(radiance),
      seed(splitMix64::after(seed + 0x517cc1b727220a95 * static_cast<std::uint64_t>(round + 1))),
      before(before),
      heavy(heavy),
      pixelCount(static_cast<double>(window.width()) * window.height()) {
    forEachPixel(window, [&](int x, int y) {
        if (isFlat(x, y)) {
            ++flat;
            contrasts += largestSquaredError(grid.pixel(x, y).mean);
            return;
        }
        ++busy;
        const double error = grid.squaredErrorOf(x, y);
        modelled += error;
        modelCost += error * grid.pixel(x, y).samples;
        busySamples += grid.pixel(x, y).samples;
    });
}

bool Audit::isFlat(int x, int y) const {
    return grid.isFlat(x, y) && !grid.pixel(x, y).isClosed;
}

// A random number of a pixel in [0, 1).
double Audit::chance(int x, int y, int what) const {
    const std::uint64_t key = splitMix64::after(seed + static_cast<std::uint64_t>(what));
    return 0x1p-53 *
           static_cast<double>(
               splitMix64::after(key ^ splitMix64::after(splitMix64::placeOf(x, y))) >> 11);
}

void Audit::lookAtFlat(double share, TimeShare& time) {
    lookAtNumbers(0, share, true, time);
}

void Audit::lookAtMore(double from, double to, TimeShare& time) {
    lookAtNumbers(from, to, false, time);
}

// @param keeps  whether what is found can be repaired: it takes memory
void Audit::lookAtNumbers(double from, double to, bool keeps, TimeShare& time) {
    for (int turn = static_cast<int>(from); turn < to; ++turn) {
        const double first = std::max(from - turn, 0.0), end = to - turn;
        grid.visitPixels(region, time, [&](int x, int y) {
            if (!isFlat(x, y)) return 0;
            const double number = chance(x, y, 0);
            return number >= first && number < end ? lookAt(x, y, turn, keeps) : 0;
        });
    }
    sumUp();
}

int Audit::lookAt(int x, int y, int turn, bool keeps) {
    checkStop(x, y, 1);
    if (ShortRays::areOn()) return 0;  // it takes too long
    const AuditedPixel found =
        audit(x, y, grid.color(x, y), grid.slope(x, y), limit, radiance,
              splitMix64::after(seed + 16 + static_cast<std::uint64_t>(turn)));
    const bool counts = contains(window, x, y);
    if (counts) looks.fetch_add(1, relaxed);
    if (!found.isWrong) return 1;
    const std::lock_guard lock(mutex);
    if (counts) products.push_back({x, y, found.product});
    if (keeps) finds.push_back(found);
    return 1 + found.judge.samples;
}

// In the same order for any number of threads.
void Audit::sumUp() {
    sortByPlace(finds);
    std::sort(products.begin(), products.end(), [](const Product& a, const Product& b) {
        return std::tie(a.y, a.x, a.squaredError) < std::tie(b.y, b.x, b.squaredError);
    });
    sum = squares = 0;
    for (const Product& product : products) {
        const double squaredError = static_cast<double>(product.squaredError);
        sum += squaredError;
        squares += squaredError * squaredError;
    }
}

// Of those that are looked at with a chance p_i, each product counts 1 / p_i times: an unbiased
// estimate of the sum (Horvitz and Thompson, A Generalization of Sampling Without Replacement from
// a Finite Universe, 1952). Nothing found is not nothing there: with 95 % confidence, less than a
// share of 3 / n is hit by no one of n samples (the rule of three), and 1 / n is the standard error
// of that share. What hides in a pixel and covers a share c of it makes a squared error of c times
// that share. A sample misses what covers most of a pixel only seldom: c = 1/4 counts.
Judgement Audit::unseen() const {
    const double n = static_cast<double>(looks);
    if (flat == 0) return {};
    if (n == 0) return {0, square(flat / pixelCount) / 16};
    const double share = flat / pixelCount;
    // By one more sample that hits something: a light far brighter than white weighs more.
    const double one = std::max(0.25 * contrasts / flat, heavy) / n;
    return {std::max(share * sum / n, 0.0), varianceOfFinds() + share * share * one * one};
}

double Audit::varianceOfFinds() const {
    if (looks == 0) return 0;
    return squares * square(flat / pixelCount / static_cast<double>(looks));
}

double Audit::varianceWithHeavy() const {
    if (looks == 0) return 0;
    return varianceOfFinds() + square(heavy * flat / pixelCount / static_cast<double>(looks));
}

// At most a tenth of all samples.
double Audit::countForBudget() const {
    const double budget = std::max(static_cast<double>(grid.samples()) / 10, 8000.);
    const double perPixel = modelCost / std::max(modelled, 1e-30) + busySamples / busy;
    return std::min(busyPixels, budget / (perPixel + fewSamples));
}

// Most of them with a chance in proportion to their error, some with the same chance for all: there
// are pixels that err and do not know it.
void Audit::lookAtBusy(TimeShare& time) {
    if (busy == 0) return;
    const double count = countForBudget();
    grid.visitPixels(window, time, [&](int x, int y) {
        if (isFlat(x, y) || grid.pixel(x, y).isClosed) return 0;
        const double error = grid.squaredErrorOf(x, y);
        const double p = count * (modelled > 0 ? 0.7 * error / modelled + 0.3 / busy : 1 / busy);
        return chance(x, y, 1) < p ? sampleAgain(x, y, std::min(p, 1.0)) : 0;
    });
    sortByPlace(again);
}

// If m is a mean of n samples and m' another one, (m - m')^2 / 2 has the mean of (m - mu)^2. That
// holds if how many samples m has does not depend on them. As it does, few samples are judged by
// so many others that these hardly err.
int Audit::sampleAgain(int x, int y, double chanceOfIt) {
    const int n = grid.pixel(x, y).samples;
    checkStop(x, y, n);
    if (ShortRays::areOn()) return 0;
    const bool isFew = n < fewSamples;
    AdaptivePixel other;
    while (other.samples < (isFew ? std::max(32, 8 * n) : n))
        refine(other, x, y, radiance, seed + 2);
    const double difference = squaredDifference(other.mean, grid.color(x, y));
    const double measured =
        isFew ? difference - std::min(static_cast<double>(squaredError(other)), difference)
              : difference / 2;
    const std::lock_guard lock(mutex);
    again.push_back({x, y, chanceOfIt, grid.squaredErrorOf(x, y), measured});
    return other.samples;
}

// The ratio of the sums, measured to modelled; its variance by linearization (Cochran, Sampling
// Techniques, chapter 6), but at least that of as many squares of normal numbers. What was thought
// before counts as another measurement.
Judgement Audit::modelFactor() const {
    double model = 0, measured = 0;
    for (const Twice& pixel : again) {
        model += pixel.model / pixel.chance;
        measured += pixel.measured / pixel.chance;
    }
    if (again.size() < 8 || !(model > 0)) return before;
    const double ratio = std::max(measured / model, 0.0);
    double variance = 0;
    for (const Twice& pixel : again)
        variance += square((pixel.measured - ratio * pixel.model) / pixel.chance / model);
    const double n = static_cast<double>(again.size());
    variance = std::max(variance, 2 * ratio * ratio / n) + 1e-12;
    const double weight = 1 / variance + 1 / before.variance;
    return {(ratio / variance + before.squaredError / before.variance) / weight, 1 / weight};
}

Judgement Audit::seen() const {
    const Judgement factor = modelFactor();
    const double model = modelled / pixelCount;
    return {factor.squaredError * model, factor.variance * model * model};
}

int Audit::medianSamplesOfFlat() const {
    std::map<int, double> counts;
    forEachPixel(window, [&](int x, int y) {
        if (isFlat(x, y)) ++counts[grid.pixel(x, y).samples];
    });
    double passed = 0;
    for (const auto& [samples, count] : counts)
        if (2 * (passed += count) >= flat) return samples;
    return 0;
}

}  // namespace sw
