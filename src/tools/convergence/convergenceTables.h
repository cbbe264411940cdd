#pragma once

#include <string>
#include <vector>

#include "tools/common/powerLaw.h"
#include "tools/common/table.h"
#include "tools/convergence/study.h"

namespace report {

/// Methods in the order of their measurements, each once.
std::vector<std::string> methodsOf(const Study& study);

/// What a curve of errors falls with.
enum class Cost : unsigned char { samples, seconds };

/// A method's RMSE over its cost, in the order of the measurements.
std::vector<Point> curve(const Study& study, const std::string& method, Cost cost);

/// Fits a curve. A sampler's 1x1 is left out: it is the pixel's centre, another kind of error.
PowerLaw slope(const Study& study, const std::string& method, Cost cost);

/// Geometric means over all scenes, as a study called `overview`; what one scene lacks is left out.
/// It has no pictures.
Study overview(const std::vector<Study>& studies);

/// The table for programs: a line for each scene, method and setting.
std::string toCsv(const std::vector<Study>& studies);

/// Tables for people, the heading first. Two columns of words in the first, one in the others.
std::vector<Row> measurementRows(const Study& study);
/// RMSE at a few grids, relative to jitter with as many samples.
std::vector<Row> samplerRows(const Study& overview);
/// How many times less than jitter methods need to reach its error, and geometric means of that.
std::vector<Row> speedUpRows(const std::vector<Study>& studies, Cost cost);

}  // namespace report
