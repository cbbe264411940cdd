#pragma once

#include <string>

#include "files.h"
#include "nff/nff.h"

/// The ball over a floor that files from the field show, in the words of their statements.
namespace test {

struct BallFile {
    std::string view = "v\nfrom 0 1 6\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0.1\n";
    std::string resolution = "resolution 96 96\n";
    std::string background = "b 0.2 0.3 0.5\n";
    std::string light = "l 4 6 5\n";
    std::string material = "f 0.8 0.4 0.2 0.9 0 0 0 0\n";
    std::string ball = "s 0 0 0 1\n";
    std::string floor = "f 0.5 0.5 0.5 0.9 0 0 0 0\np 4\n-4 -1 4\n4 -1 4\n4 -1 -4\n-4 -1 -4\n";

    std::string text() const {
        return view + resolution + background + light + material + ball + floor;
    }
};

inline std::string replaced(std::string where, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = where.find(what, at)) != std::string::npos; at += by.size())
        where.replace(at, what.size(), by);
    return where;
}

/// Whether a file holds the ball, the floor, the light and the background, and nothing warns.
inline bool isBallScene(const sw::NffScene& file) {
    sw::Intersection ball, floor;
    const auto& lights = file.scene.lights();
    return file.scene.intersect(sw::Ray(Vec3(0, 0, 6), Vec3(0, 0, -1)), ball) && ball.hitT == 5 &&
           distance(ball.material.color, 0.9f * Color(0.8f, 0.4f, 0.2f)) < 1e-6 &&
           file.scene.intersect(sw::Ray(Vec3(3, 5, 3), Vec3(0, -1, 0)), floor) && floor.hitT == 6 &&
           distance(floor.material.color, 0.9f * Color(0.5f, 0.5f, 0.5f)) < 1e-6 &&
           lights.size() == 1 && distance(lights[0].position, Vec3(4, 6, 5)) == 0 &&
           distance(lights[0].color, Color(1, 1, 1)) == 0 &&
           distance(file.scene.background(), Color(0.2f, 0.3f, 0.5f)) == 0;
}

}  // namespace test
