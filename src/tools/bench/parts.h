#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/bench/result.h"
#include "tools/common/measure.h"

namespace bench {

struct Setup {
    bool quick = false;  ///< only check that everything runs
    bool full = false;   ///< also larger models
    std::filesystem::path output = "report";

    /// An odd number.
    int repetitions(int usual) const { return quick ? 1 : usual; }
};

using report::median;
using report::processorSecondsOf;
using report::secondsOf;
using report::Times;

// The parts of the benchmark. Each adds lines to the result.

/// The default lab picture, against the original's way and Embree; two threads against one.
void compareLab(const Setup& setup, Lines& lines);

bool isPovRayInstalled();

/// Scenes of swtracer-scene, traced by POV-Ray where it is installed.
void comparePovRay(const Setup& setup, Lines& lines);

/// Build time, memory and rays per second of large models, against Embree.
void compareModels(const Setup& setup, Lines& lines);

/// How time and visited nodes per ray grow with the number of triangles.
void measureGrowth(const Setup& setup, Lines& lines);

/// The shares of loading, building, tracing and writing in a run; time and size of the PNG.
void measureSteps(const Setup& setup, Lines& lines);

/// How fast the text of a large scene is read, by one thread.
void measureLoading(const Setup& setup, Lines& lines);

}  // namespace bench
