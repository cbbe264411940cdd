#include <utility>

#include "lab/lightAndFloor.h"
#include "lab/photo.h"

using namespace lab;
using namespace sw;

namespace {

// What the eye sees of spheres. The light is where the eye is, so all of that is lit.
struct Lit {
    int points = 0, black = 0;
    Vec3 blackPoint;
};

// Looks at spheres of that size in several places. They all lie between light and origin, so that
// even a light's place, taken for the direction to it (task 1), lights what the light does.
Lit look(float radius, float farAway) {
    Lit lit;
    for (const Vec3& side : {Vec3(0.48f, 0.6f, 0.64f), Vec3(-0.8f, 0, 0.6f), Vec3(0, -1, 0)}) {
        const Vec3 centre = farAway * side, eye = centre + 3 * radius * side;
        Scene scene;
        scene.push(Sphere(centre, radius, matte({1, 1, 1})));
        scene.push(Light(eye));
        photo(Camera(eye, centre, {0.1f, 0.2f, 1}, 30), [&](const Ray& ray) {
            Intersection hit;
            if (!scene.intersect(ray, hit)) return Color();
            ++lit.points;
            if (isBlack(traceRay(ray, scene, 0))) {
                ++lit.black;
                lit.blackPoint = hit.position;
            }
            return Color();
        });
    }
    return lit;
}

}  // namespace

TEST_CASE("a sphere casts no shadow on its own lit side", "[lab3]") {
    requireAnyShadow();
    for (const auto& [radius, farAway] :
         {std::pair(3.f, 0.f), std::pair(3.f, 25.f), std::pair(11.f, 110.f)}) {
        const Lit lit = look(radius, farAway);
        if (lit.black == 0) continue;
        fail({"spheres of radius " + lab::text(radius) + " at a distance of " + lab::text(farAway) +
                  " from (0, 0, 0), each alone with a light",
              std::to_string(lit.black) + " of " + std::to_string(lit.points) +
                  " lit points are black, as " + lab::text(lit.blackPoint),
              "none",
              lit.black == lit.points
                  ? "nothing hides the light, and still everything is dark: is this a shadow, or "
                    "task 1?"
                  : "the surface shadows itself: its points are rounded and lie a little below or "
                    "above it, so the shadow ray must start a little off"});
    }
}

// Only the floor is asked for its colour, from where it faces the light; and that only for black or
// not. So the state of task 1 does not matter.
TEST_CASE("balls over a floor: the picture of light and shadow", "[lab3]") {
    Scene scene = floorUnder({Light({3, -2, 8})});
    const Material ball = matte({1, 1, 1});
    for (const Sphere& sphere :
         {Sphere({-1, 1.5f, 1.5f}, 1.25f, ball), Sphere({-2, -1.5f, 2.5f}, 0.75f, ball),
          Sphere({2.5f, 1, 0.75f}, 0.75f, ball), Sphere({4, -2.5f, 10}, 1, ball)})
        scene.push(sphere);
    const Image image =
        photo(Camera({1, -9, 9}, {-1, 0.5f, 0.5f}, {0, 0, 1}, 46), [&](const Ray& ray) {
            Intersection hit;
            if (!scene.intersect(ray, hit)) return Color(0.05f, 0.05f, 0.2f);
            if (hit.position[2] != 0) return Color(0.2f, 0.2f, 0.2f);
            return isBlack(traceRay(ray, scene, 0)) ? Color(0, 0, 0) : Color(1, 1, 1);
        });
    expectPicture("lab3-shadows", image, 2, 12,
                  {"where the floor is lit (white) and where it is in shadow (black); the balls "
                   "themselves are grey",
                   "follow the line from a wrong point to the light: does a ball stand on it, and "
                   "between the two?"});
}
