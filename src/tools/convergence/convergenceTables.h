#pragma once

#include <string>
#include <vector>

#include "tools/common/powerLaw.h"
#include "tools/common/table.h"
#include "tools/convergence/study.h"

namespace report {

/// The methods, each once, in the order of their measurements.
std::vector<std::string> methodsOf(const Study& study);

/// The cost on the x axis of an error curve.
enum class Cost : unsigned char { samples, seconds };

/// A method's RMSE over its cost, in the order of the measurements.
std::vector<Point> curve(const Study& study, const std::string& method, Cost cost);

/// Fits a curve. A sampler's 1x1 is left out: it is the pixel's centre, whose error is of another
/// kind.
PowerLaw slope(const Study& study, const std::string& method, Cost cost);

/// Geometric means over all scenes, as a study called `overview`. Settings that a scene lacks are
/// left out. It has no pictures.
Study overview(const std::vector<Study>& studies);

/// The CSV table: a line for each scene, method and setting.
std::string toCsv(const std::vector<Study>& studies);

/// Tables for readers, the heading first. The first has two columns of words, the others one.
std::vector<Row> measurementRows(const Study& study);
/// RMSE at a few grids, relative to jitter with as many samples.
std::vector<Row> samplerRows(const Study& overview);
/// How many times cheaper than jitter the methods reach its error, and the geometric means.
std::vector<Row> speedUpRows(const std::vector<Study>& studies, Cost cost);

}  // namespace report
