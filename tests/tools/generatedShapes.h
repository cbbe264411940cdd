#pragma once

#include <glm/geometric.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support.h"

namespace test {

struct Ball {
    dvec3 center;
    double radius;
};
struct Corners {
    dvec3 v[3];
};
struct Tube {
    dvec3 base;
    double baseRadius;
    dvec3 apex;
    double apexRadius;
};

/// The shapes of a scene, read with nothing of the library.
struct Shapes {
    std::vector<Ball> balls;
    std::vector<Corners> triangles;
    std::vector<Tube> tubes;
    int squares = 0;

    explicit Shapes(const std::string& text) {
        std::istringstream in(text);
        const auto point = [&in] {
            dvec3 p;
            in >> p.x >> p.y >> p.z;
            return p;
        };
        for (std::string word; in >> word;) {
            int corners = 0;
            if (word == "p" && in >> corners && corners == 3) {
                const dvec3 a = point(), b = point();
                triangles.push_back({{a, b, point()}});
            } else if (word == "p") {
                ++squares;
            } else if (word == "s") {
                balls.push_back({point(), 0});
                in >> balls.back().radius;
            } else if (word == "c") {
                tubes.push_back({point(), 0, {}, 0});
                in >> tubes.back().baseRadius;
                tubes.back().apex = point();
                in >> tubes.back().apexRadius;
            }
        }
    }
    std::size_t count() const {
        return balls.size() + triangles.size() + tubes.size() + static_cast<std::size_t>(squares);
    }
};

/// How far two balls are from touching; negative if they overlap.
inline double gap(const Ball& a, const Ball& b) {
    return glm::distance(a.center, b.center) - a.radius - b.radius;
}

}  // namespace test
