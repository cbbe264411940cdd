#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "options.h"
#include "picture.h"
#include "swScene.h"

/// Wall time of the steps of a run, in seconds.
struct StepTimes {
    double load = 0, build = 0, trace = 0, write = 0;
    double total() const { return load + build + trace + write; }
};

/// Measures one step after the other.
class StopWatch {
public:
    /// Seconds since the last lap, or since the start.
    double lap();

private:
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// One line on stderr for each.
void printWarnings(const std::vector<std::string>& warnings);

/// A progress bar on stderr, or nothing where stderr is no terminal. Clears itself at the end.
std::function<void(int done, int total)> makeProgressBar(bool quiet);

/// One line: picture, size, samples, threads, wall time, rays.
std::string summary(const Options& options, const Picture& picture, const StepTimes& times);

/// The same and more as JSON: what was traced, what was left out, and what the scene did not need.
std::string statsJson(const Options& options, const Picture& picture, const StepTimes& times,
                      const sw::Scene& scene);
