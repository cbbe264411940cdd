#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "adaptive/adaptiveGrid.h"

namespace sw {

/// A mean squared error, and the variance of that estimate.
struct Judgement {
    double squaredError = 0;
    double variance = 0;
};

/// Judges a grid's picture by samples that its own know nothing of.
///
/// Flat pixels are those that hardly show an error. What they have missed is found by one more
/// sample in some of them, and where that differs, by many more (see productOf()). One that agrees
/// costs one sample: the product is 0, whatever else there may be. So the audit is sharp where the
/// model is blind, and costs little where there is nothing to be found.
///
/// In busy pixels, products have the size of the variance of samples, not of means. There the model
/// stays, times a factor that is measured: some pixels, with a chance in proportion to their
/// squared error, are sampled a second time.
class Audit {
public:
    /// @param region  of the grid
    /// @param window  whose error is judged
    /// @param limit   RMS error up to which a pixel is flat, and difference up to which two colours
    ///                are the same
    /// @param seed    of the picture
    /// @param round   number of the audit, for other random numbers
    /// @param before  what the model's factor is thought to be
    /// @param heavy   mean product of what was found before: what is missed may be like it
    Audit(AdaptiveGrid& grid, const Window& region, const Window& window, float limit,
          const RadianceAt& radiance, std::uint64_t seed, int round, const Judgement& before,
          double heavy);

    /// Looks at a share of the flat pixels: those with a random number in [0, share).
    void lookAtFlat(double share, TimeShare& time);
    /// Looks at more of them, with a number in [from, to), only to judge. Above 1, at all again.
    void lookAtMore(double from, double to, TimeShare& time);
    /// Looks at some busy pixels.
    void lookAtBusy(TimeShare& time);

    /// What the flat pixels add to the window's mean squared error.
    Judgement unseen() const;
    /// Its variance, as far as it comes from what was found.
    double varianceOfFinds() const;
    /// The same, with one more that is like what was found before.
    double varianceWithHeavy() const;
    /// What the busy pixels add.
    Judgement seen() const;
    /// By what the model's squared error is to be multiplied.
    Judgement modelFactor() const;

    /// Flat pixels that have missed something, of those that lookAtFlat() has looked at, row by
    /// row.
    const std::vector<AuditedPixel>& wrong() const { return finds; }
    /// Mean product of what was found; 0: nothing.
    double meanProduct() const {
        return products.empty() ? 0 : sum / static_cast<double>(products.size());
    }
    /// Whether anything was found, by lookAtMore() as well.
    bool hasFound() const { return !products.empty(); }
    /// Whether a pixel is among those that lookAtFlat(0, share) looks at, for a share up to 1.
    bool isLookedAt(int x, int y, double share) const {
        return isFlat(x, y) && chance(x, y, 0) < share;
    }
    std::uint64_t pixels() const { return looks + again.size(); }
    int medianSamplesOfFlat() const;
    /// Mean squared error of a flat pixel.
    double unseenPerPixel() const { return looks > 0 ? sum / static_cast<double>(looks) : 0; }

private:
    /// A busy pixel that was sampled twice.
    struct Twice {
        int x, y;
        double chance;           // of being looked at
        double model, measured;  // squared errors
    };
    /// What was found in a flat pixel of the window.
    struct Product {
        int x, y;
        float squaredError;  // an unbiased estimate
    };
    bool isFlat(int x, int y) const;
    double chance(int x, int y, int what) const;
    int lookAt(int x, int y, int turn, bool keeps);
    void lookAtNumbers(double from, double to, bool keeps, TimeShare& time);
    double countForBudget() const;
    int sampleAgain(int x, int y, double chanceOfIt);
    void sumUp();

    AdaptiveGrid& grid;
    const Window region, window;
    const float limit;
    const RadianceAt& radiance;
    const std::uint64_t seed;
    const Judgement before;
    const double heavy;

    std::mutex mutex;  // guards these
    std::vector<AuditedPixel> finds;
    std::vector<Product> products;
    std::vector<Twice> again;
    std::atomic<std::uint64_t> looks{0};  // at flat pixels of the window

    // Of the window:
    double pixelCount, flat = 0, busy = 0, busySamples = 0;
    double contrasts = 0;                // sum of the largest squared errors of flat pixels
    double modelled = 0, modelCost = 0;  // sum of busy pixels' squared errors, and times samples
    double sum = 0, squares = 0;         // of the products
};

}  // namespace sw
