#pragma once

#include <chrono>
#include <string>

#include "app/options.h"
#include "swRenderer.h"

/// Wall time of the steps of a run, in seconds.
struct StepTimes {
    double load = 0, build = 0, record = 0, trace = 0, write = 0;
    double total() const { return load + build + record + trace + write; }
};

/// Measures one step after the other.
class StopWatch {
public:
    /// Seconds since the last lap, or since the start.
    double lap();

private:
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

/// One line: picture, size, samples, threads, wall time, rays, estimated error.
std::string summary(const Options& options, const sw::RenderResult& result, const StepTimes& times);

/// Samples per pixel, on average.
double samplesPerPixel(const sw::RenderResult& result);
