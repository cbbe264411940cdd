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

/// The least-squares line through the logarithms. Points without logarithms are left out. Both
/// numbers are NaN unless two different x remain.
PowerLaw fitPowerLaw(const std::vector<Point>& points);

/// The x where a falling curve first reaches y, interpolated between the points' logarithms.
/// @param points  in order of growing x
/// @return        the first point's x if its y is low enough; NaN if no point's is
double firstReach(const std::vector<Point>& points, double y);

/// NaN for no values; all values are positive.
double geometricMean(const std::vector<double>& values);

}  // namespace report
