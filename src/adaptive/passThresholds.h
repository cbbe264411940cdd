#pragma once

#include <algorithm>
#include <vector>

namespace sw {

/// The thresholds of all passes but the first. A pixel with n samples is refined while its error is
/// above both the tolerance and threshold * sqrt(n): errors e fall like n^-3/4, so one more sample
/// lowers the sum of e^2 by about 1.5 e^2 / n. Samples are best spent where that is largest.
/// Thresholds fall by a constant factor. With a tolerance, the list ends where thresholds are too
/// small to matter, and then come passes that leave no error above the tolerance. The list depends
/// on the tolerance alone: so the picture is independent of the window.
inline std::vector<float> passThresholds(float tolerance) {
    constexpr float first = 0.05f, smallest = 1e-8f;
    const float ratio = tolerance > 0 ? 0.4f : 0.8f;
    constexpr int settlingPasses = 10;
    const float last = tolerance > 0 ? std::max(smallest, tolerance / 32) : smallest;
    std::vector<float> list;
    for (float threshold = first; threshold > last; threshold *= ratio) list.push_back(threshold);
    if (tolerance > 0) list.insert(list.end(), settlingPasses, 0.f);
    return list;
}

}  // namespace sw
