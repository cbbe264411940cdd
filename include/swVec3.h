#pragma once

#include <cmath>
#include <type_traits>

namespace sw {

/// A vector, point or colour of three floats.
/// Careful: `u * v` is the dot product and `u % v` the cross product.
struct Vec3 {
    float m[3];

    Vec3() : m{0, 0, 0} {}
    Vec3(float x, float y, float z) : m{x, y, z} {}

    float x() const { return m[0]; }
    float y() const { return m[1]; }
    float z() const { return m[2]; }
    float operator[](int i) const { return m[i]; }
    float& operator[](int i) { return m[i]; }

    Vec3 operator-() const { return {-m[0], -m[1], -m[2]}; }

    Vec3& operator+=(const Vec3& v) {
        for (int i = 0; i < 3; ++i) m[i] += v.m[i];
        return *this;
    }
    Vec3& operator-=(const Vec3& v) {
        for (int i = 0; i < 3; ++i) m[i] -= v.m[i];
        return *this;
    }
    Vec3& operator*=(float s) {
        for (int i = 0; i < 3; ++i) m[i] *= s;
        return *this;
    }

    /// Componentwise product: the colour of a surface of this colour in light of colour v.
    Vec3 times(const Vec3& v) const { return {m[0] * v.m[0], m[1] * v.m[1], m[2] * v.m[2]}; }

    bool isZero() const { return m[0] == 0 && m[1] == 0 && m[2] == 0; }

    /// Euclidean length. Computed in double, so that components from 1e-36 to 1e37 neither
    /// underflow nor overflow when squared.
    float norm() const { return static_cast<float>(length()); }

    /// Scales this vector, in place, to length 1. Keeps a zero or non-finite vector as it is.
    Vec3& normalize() {
        const double l = length();
        if (!(l > 0 && l < HUGE_VAL)) return *this;
        for (int i = 0; i < 3; ++i) m[i] = static_cast<float>(m[i] / l);
        return *this;
    }

private:
    double length() const {
        const double x = m[0], y = m[1], z = m[2];
        return std::sqrt(x * x + y * y + z * z);
    }
};

/// Linear red, green and blue; 1 is the brightest that a picture shows.
using Color = Vec3;

inline Vec3 operator+(const Vec3& u, const Vec3& v) {
    return {u.m[0] + v.m[0], u.m[1] + v.m[1], u.m[2] + v.m[2]};
}

inline Vec3 operator-(const Vec3& u, const Vec3& v) {
    return {u.m[0] - v.m[0], u.m[1] - v.m[1], u.m[2] - v.m[2]};
}

/// Any number scales a vector: `v * 2`, `v * 0.5`, `0.5f * v`, `v / 3`.
template <typename Number>
requires std::is_arithmetic_v<Number> Vec3 operator*(const Vec3& v, Number s) {
    const float f = static_cast<float>(s);
    return {v.m[0] * f, v.m[1] * f, v.m[2] * f};
}

template <typename Number>
requires std::is_arithmetic_v<Number> Vec3 operator*(Number s, const Vec3& v) {
    return v * s;
}

template <typename Number>
requires std::is_arithmetic_v<Number> Vec3 operator/(const Vec3& v, Number s) {
    const float f = static_cast<float>(s);
    return {v.m[0] / f, v.m[1] / f, v.m[2] / f};
}

/// Dot product.
inline float operator*(const Vec3& u, const Vec3& v) {
    return u.m[0] * v.m[0] + u.m[1] * v.m[1] + u.m[2] * v.m[2];
}

/// Cross product, right-handed: x % y = z.
inline Vec3 operator%(const Vec3& u, const Vec3& v) {
    return {u.m[1] * v.m[2] - u.m[2] * v.m[1],  //
            u.m[2] * v.m[0] - u.m[0] * v.m[2],  //
            u.m[0] * v.m[1] - u.m[1] * v.m[0]};
}

}  // namespace sw
