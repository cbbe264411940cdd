#pragma once

#include <vector>

namespace report {

struct Point {
    double x, y;
};

/// y = factor * x^exponent: a straight line of that slope where both axes are logarithmic.
struct PowerLaw {
    double factor, exponent;
};

/// The line of least squares through the logarithms. Points that have none are left out; both
/// numbers are NaN unless two different x remain.
PowerLaw fitPowerLaw(const std::vector<Point>& points);

/// Where a falling curve first is as low as y, by straight lines between the points' logarithms.
/// @param points  in order of growing x
/// @return        the first point's x where that one is low enough; NaN where none is
double firstReach(const std::vector<Point>& points, double y);

/// NaN for none; values are positive.
double geometricMean(const std::vector<double>& values);

}  // namespace report
