#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/extras.h"
#include "app/options.h"
#include "app/report.h"
#include "rayTree/rayProbe.h"
#include "swNff.h"
#include "swRenderer.h"

/// The steps of one run of the program. main() takes them in this order.
class Run {
public:
    explicit Run(Options options) : options(std::move(options)) {}

    /// Reads the scene file and sets up the camera for the picture's size.
    /// @return  scene and camera; they live as long as the run
    /// @throws sw::NffError, UsageError for an invalid size, sw::FileError if the output could not
    ///         be written
    const sw::NffScene& loadScene();

    /// Renders the picture as the command line says, on all threads.
    /// @param traceRay     radiance along a ray, for sampling without samplePixel
    /// @param samplePixel  colour of the pixel whose top left corner is (x, y)
    void render(const rayTree::Trace& traceRay,
                const std::function<sw::Color(int x, int y)>& samplePixel);

    /// Writes the output: the picture, or what the command line asks for instead.
    /// @throws sw::FileError
    void write();

    int samples() const { return options.samples; }  ///< per side of the grid in every pixel
    int depth() const { return options.depth; }      ///< of the recursion

private:
    Options options;
    std::optional<sw::NffScene> file;
    std::vector<sw::NffShape> shapes;  // for --pixel and --explore
    std::shared_ptr<const Recording> recording;
    std::optional<sw::RenderResult> result;
    std::string pixelText;
    StepTimes seconds;
    StopWatch watch;
};

/// Reads the command line, runs the steps, and reports a failure in one line on stderr.
/// @return  exit code: 0 done, 1 unexpected, 2 command line, 3 scene, 4 output, 128 + n signal n
int runProgram(int argc, const char* const* argv, const std::function<void(Run&)>& steps);
