#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/options.h"
#include "app/report.h"
#include "rayTree/rayProbe.h"
#include "swNff.h"
#include "swRenderer.h"

/// The steps of one run of the program. main() takes them in this order.
class Run {
public:
    explicit Run(Options options) : options(std::move(options)) {}

    /// Reads the scene file, and sets the camera up for the size of the picture.
    /// @return  scene and camera; they live as long as the run
    /// @throws sw::NffError, UsageError for a size that cannot be, sw::FileError where the outcome
    ///         could not be written
    const sw::NffScene& loadScene();

    /// Renders the picture in the way that the command line asks for, on all threads.
    /// @param traceRay     radiance along a ray, for ways that place samples themselves
    /// @param samplePixel  colour of the pixel whose top left corner is (x, y)
    void render(const rayTree::Trace& traceRay,
                const std::function<sw::Color(int x, int y)>& samplePixel);

    /// Writes the outcome: out.png, or what else was asked for.
    /// @throws sw::FileError
    void write();

    int samples() const { return options.samples; }  ///< per side of the grid in every pixel
    int depth() const { return options.depth; }      ///< of the recursion

private:
    Options options;
    std::optional<sw::NffScene> file;
    std::vector<sw::NffShape> shapes;  // for --pixel
    std::optional<sw::RenderResult> result;
    std::string pixelText;
    StepTimes seconds;
    StopWatch watch;
};

/// Reads the command line, takes the steps, and explains a failure by one line on stderr.
/// @return  exit code: 0 done, 1 unexpected, 2 command line, 3 scene, 4 output
int runProgram(int argc, const char* const* argv, const std::function<void(Run&)>& steps);
