#pragma once

#include <memory>
#include <vector>

#include "swPrimitive.h"

namespace report {

/// What one method is timed on: primitive i meets ray i.
using Primitives = std::vector<std::unique_ptr<sw::Primitive>>;

struct Timing {
    double nanoseconds;  ///< per call, median of the repetitions
    double ratio;        ///< to the first method in the same repetition, median
};

/// Times Primitive::intersect for several methods on the same rays. As Google Benchmark with
/// interleaved repetitions does: each takes about a millisecond, so that a machine that slows down
/// meanwhile does so for all methods alike.
std::vector<Timing> timeMethods(const std::vector<Primitives>& methods,
                                const std::vector<sw::Ray>& rays, int repetitions);

}  // namespace report
