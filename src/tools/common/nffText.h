#pragma once

#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>
#include <utility>

namespace scenes {

using glm::dvec3;

/// The text of a scene, statement by statement. Numbers are rounded to float and written with
/// the fewest digits that identify that float, in any locale.
class NffText {
public:
    /// A picture of 512 x 512 under a blue sky, with a field of view of 45 degrees.
    NffText(const dvec3& from, const dvec3& at, const dvec3& up);

    void light(const dvec3& position) { statement("l", {position}, {}); }
    /// Material of the shapes that follow: diffuse part, reflectivity, transparency and refractive
    /// index.
    void material(const dvec3& color, double kd, double ks, double t = 0, double index = 0) {
        statement("f", {color}, {kd, ks, 0, t, index});
    }
    void sphere(const dvec3& center, double radius) { statement("s", {center}, {radius}); }
    void cone(const dvec3& base, double baseRadius, const dvec3& apex, double apexRadius) {
        text += "c";
        append(base), append(baseRadius), append(apex), append(apexRadius);
        text += '\n';
    }
    void triangle(const dvec3& a, const dvec3& b, const dvec3& c) {
        statement("p 3", {a, b, c}, {});
    }
    void square(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
        statement("p 4", {a, b, c, d}, {});
    }

    std::string take() { return std::move(text); }

private:
    using Points = std::initializer_list<dvec3>;
    using Numbers = std::initializer_list<double>;
    void statement(const char* word, Points points, Numbers numbers);
    void append(double number);
    void append(const dvec3& point) {
        for (int i = 0; i < 3; ++i) append(point[i]);
    }

    std::string text;
};

}  // namespace scenes
