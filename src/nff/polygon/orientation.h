#pragma once

#include <array>
#include <cmath>

namespace sw {

/// A point of a plane whose coordinates are floats.
struct Point2 {
    double x, y;

    bool operator==(const Point2&) const = default;
    /// From left to right; if x is equal, upwards.
    bool operator<(const Point2& p) const { return x < p.x || (x == p.x && y < p.y); }
};

/// The sign of a sum of doubles, without rounding: every term is added to a list of doubles that
/// do not overlap and whose sum is exact (Shewchuk, Adaptive Precision Floating-Point Arithmetic,
/// 1997, "grow-expansion" with zero elimination). The last and largest of them has the sum's sign.
template <std::size_t count>
double exactSumSign(const std::array<double, count>& terms) {
    std::array<double, count> parts;
    std::size_t size = 0;
    for (double sum : terms) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const double a = sum, b = parts[k];
            sum = a + b;
            const double bRounded = sum - a;
            const double error = (a - (sum - bRounded)) + (b - bRounded);
            if (error != 0) parts[kept++] = error;
        }
        if (sum != 0) parts[kept++] = sum;
        size = kept;
    }
    return size > 0 ? parts[size - 1] : 0;
}

/// The side of the line from a to b on which the point c lies.
/// @return  positive: on the left, a b c is counter-clockwise; negative: on the right; 0: on the
///          line. The sign is exact, so decisions about the same points agree.
inline double orientation(const Point2& a, const Point2& b, const Point2& c) {
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
    // Three roundings of 2^-53 per product and one of the difference: beyond this, its sign is
    // true.
    if (std::fabs(left - right) >= 0x1p-50 * (std::fabs(left) + std::fabs(right)))
        return left - right;
    // Products of two floats are exact in double.
    return exactSumSign(std::array{a.x * b.y, -a.y * b.x, b.x * c.y, -b.y * c.x,  //
                                   c.x * a.y, -c.y * a.x});
}

}  // namespace sw
