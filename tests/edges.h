#pragma once

#include <cmath>
#include <vector>

#include "support.h"
#include "swSamplePattern.h"
#include "swSampling.h"

/// Pixels that a straight edge cuts, with their exact mean: pictures without rays.
namespace test {

/// Bright where a x + b y > c, in a pixel of 0..1.
struct Edge {
    double a, b, c;

    float operator()(float x, float y) const {
        return a * static_cast<double>(x) + b * static_cast<double>(y) > c ? 1.f : 0.f;
    }

    /// The bright part of the pixel. The integral over y of the bright length along x is, with
    /// F(s) = max(s, 0)^2 / 2, a second difference of F; a and b are not 0.
    double area() const {
        const auto f = [](double s) { return s > 0 ? s * s / 2 : 0; };
        return (f(a + b - c) - f(a - c) - f(b - c) + f(-c)) / (a * b);
    }
};

/// Any direction, and any place at which it may cut the pixel: a line at random in the sense of
/// integral geometry.
inline Edge randomEdge(Random& random) {
    const double angle = random.uniform(0, 2 * std::acos(-1.0));
    const double a = std::cos(angle), b = std::sin(angle);
    const double reach = std::sqrt(0.5);
    return {a, b, (a + b) / 2 + random.uniform(-reach, reach)};
}

constexpr int edges = 20000;

/// The RMSE of the means of n x n samples over many such pixels.
inline double edgeRmse(sw::SamplePattern pattern, int n) {
    Random random(1);
    double squares = 0;
    for (int i = 0; i < edges; ++i) {
        const Edge edge = randomEdge(random);
        sw::seedPixel(7, i, n);
        const auto gray = [&](float x, float y) { return sw::Color(edge(x, y), 0, 0); };
        const double mean = sw::samplePixelWith(pattern, 0, 0, n, gray)[0];
        squares += (mean - edge.area()) * (mean - edge.area());
    }
    return std::sqrt(squares / edges);
}

/// Least squares: the slope of log RMSE over the logarithm of the number of samples.
inline double fittedSlope(sw::SamplePattern pattern, const std::vector<int>& sides) {
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const int n : sides) {
        const double x = std::log(n * n), y = std::log(edgeRmse(pattern, n));
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    const double count = static_cast<double>(sides.size());
    return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

}  // namespace test
