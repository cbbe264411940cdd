#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "swImage.h"
#include "swMetrics.h"

namespace report {

/// Results of one method in one scene. The repetitions have different seeds.
struct Measurement {
    std::string method;   ///< the sampler's name, or `adaptive`
    std::string setting;  ///< its grid, as 3x3, or the tolerance
    double samples = 0;   ///< per pixel, on average
    double rays = 0;      ///< of all kinds, in the last repetition
    double seconds = 0;   ///< median of the repetitions
    sw::Metrics error;    ///< against the reference: RMSE (and PSNR) is root mean square over
                          ///< the repetitions, `visible` their mean, the rest from the worst one
    double estimatedRmse = 0;  ///< root mean square over the repetitions; NaN: no estimate
};

/// A picture of a method's error, see sw::heatMap().
struct ErrorPicture {
    std::string method, setting;
    sw::Image image;
};

struct Study {
    std::string scene;
    sw::Image reference;
    double referenceError;  ///< estimated RMSE
    std::vector<Measurement> measurements;
    std::vector<ErrorPicture> errors;  ///< of a few methods
};

struct StudyEffort {
    int size = 128;                 ///< pixels of the pictures' longer side
    int largestGrid = 8;            ///< N: the samplers take 1, 4, ..., N * N samples per pixel
    int repetitions = 3;            ///< samplers' grids above 5x5: only one
    std::vector<float> tolerances;  ///< of adaptive sampling
    int referenceGrid = 32;
};

/// Renders a scene with all methods and compares the pictures with a converged one.
/// @throws sw::NffError
Study studyScene(const std::filesystem::path& scene, const StudyEffort& effort);

}  // namespace report
