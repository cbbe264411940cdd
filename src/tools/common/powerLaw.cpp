#include "tools/common/powerLaw.h"

#include <cmath>
#include <limits>

namespace report {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<Point> logarithms(const std::vector<Point>& points) {
    std::vector<Point> result;
    for (const Point& p : points)
        if (p.x > 0 && p.y > 0 && p.x < HUGE_VAL && p.y < HUGE_VAL)
            result.push_back({std::log(p.x), std::log(p.y)});
    return result;
}

}  // namespace

PowerLaw fitPowerLaw(const std::vector<Point>& points) {
    const std::vector<Point> logs = logarithms(points);
    const double n = static_cast<double>(logs.size());
    Point mean{0, 0};
    for (const Point& p : logs) mean = {mean.x + p.x / n, mean.y + p.y / n};
    double xx = 0, xy = 0;
    for (const Point& p : logs) {
        xx += (p.x - mean.x) * (p.x - mean.x);
        xy += (p.x - mean.x) * (p.y - mean.y);
    }
    if (!(xx > 1e-20)) return {nan, nan};  // rounding of equal x stays below this
    return {std::exp(mean.y - xy / xx * mean.x), xy / xx};
}

double firstReach(const std::vector<Point>& points, double y) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!(points[i].y <= y)) continue;
        if (i == 0) return points[0].x;
        const PowerLaw line = fitPowerLaw({points[i - 1], points[i]});
        const double x = std::pow(y / line.factor, 1 / line.exponent);
        return x > 0 ? x : points[i].x;  // it has no logarithm
    }
    return nan;
}

double geometricMean(const std::vector<double>& values) {
    if (values.empty()) return nan;
    double sum = 0;
    for (const double value : values) sum += std::log(value);
    return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace report
