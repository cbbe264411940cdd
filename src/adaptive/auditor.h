#pragma once

#include <memory>

#include "adaptive/audit.h"

namespace sw {

/// What a picture's error is to be; 0: no limit.
struct ErrorLimits {
    float tolerance = 0;  ///< of a pixel
    float targetRmse = 0;
};

/// Audits a grid from time to time, and keeps what it has found.
class Auditor {
public:
    /// @param pixels  of the full picture
    Auditor(AdaptiveGrid& grid, const Window& region, const Window& window, double pixels,
            const RadianceAt& radiance, std::uint64_t seed, const ErrorLimits& limits);

    /// Audits the picture, without a change to it.
    /// @param sharpens  whether to look at more pixels if the first look found something
    void audit(TimeShare& share, bool sharpens);

    /// Looks only by what factor the model errs.
    void auditModel(TimeShare& share);
    std::uint64_t samplesAtModelAudit() const { return modelSamples; }

    /// With a tolerance: repairs what the last audit has found wrong, and has blocks sampled again.
    /// If there are no such blocks, the audit is sharpened before.
    /// @return  whether there are
    bool feedBackByBlocks(TimeShare& share);
    /// Without: repairs it, and lets all flat pixels have the error that the audit has found.
    void feedBack();
    /// Ends all feed-back: the errors are those that the last audit has found.
    /// @param repairs  whether what it has found wrong is repaired
    void settle(bool repairs);

    bool hasAudited() const { return last != nullptr; }
    std::uint64_t pixels() const { return audited; }
    std::uint64_t samplesAtAudit() const { return samples; }
    double seconds() const { return took; }
    /// The picture's mean squared error, with its variance, as found by the last audit.
    Judgement found() const;
    /// Its standard error, without what nothing was found of.
    double sway() const;

private:
    double firstShare() const;
    float flatLimit() const;
    std::unique_ptr<Audit> newAudit();
    void learn(const Audit& audit);
    bool isSharp(const Audit& audit) const;
    void sharpen(Audit& audit, TimeShare& share);
    void repairAll(bool spread);

    AdaptiveGrid& grid;
    const Window region, window;
    const double pictureSize;
    const RadianceAt& radiance;
    const std::uint64_t seed;
    const ErrorLimits limits;
    std::unique_ptr<Audit> last;
    Judgement factor{1, 0.4};  // of the model: often wrong by a half
    double heavy = 0;          // largest mean product of an audit
    std::uint64_t modelSamples = 0;
    double repaired = 0;      // squared error that was taken from the window since
    bool isRepaired = false;  // what the last audit has found wrong
    int rounds = 0;
    std::uint64_t audited = 0, samples = 0;
    double took = 0;
};

}  // namespace sw
