#include <string>
#include <utility>

#include "lab/lightAndFloor.h"
#include "lab/photo.h"
#include "lab/requireShadows.h"
#include "lab/shadowHints.h"

using namespace lab;
using namespace sw;

namespace {

// A sphere that rays from the eye alone can meet: it has no shadow.
class Shadowless : public Ball {
public:
    Shadowless(const Sphere& sphere, const Vec3& eye, const std::shared_ptr<Asked>& asked)
        : Ball(sphere, asked), eye(eye) {}
    bool intersect(const Ray& ray, Intersection& hit) const override {
        return (ray.orig - eye).isZero() && Ball::intersect(ray, hit);
    }

private:
    Vec3 eye;
};

// What the eye sees of spheres. The light is where the eye is, so all of that is lit.
struct Dimmed {
    int seen = 0, wrong = 0;
    Vec3 where, normal;  // of a wrong point
    Vec3 light;
    Asked rays;  // sent from there
};

// Looks at a sphere with its light, and compares every point with how it is lit where the sphere
// cannot shadow itself. So it does not matter how the student's own shading (task 1) comes out.
void look(const Sphere& sphere, const Vec3& eye, Dimmed& dimmed) {
    const Exposure exposure = shown(Light(eye), eye);
    Stage stage(exposure, {Light(eye)}, {sphere}, eye);
    Stage shadowless(exposure, {Light(eye)}, {}, eye);
    shadowless.push(std::make_shared<Shadowless>(sphere, eye, shadowless.asked()));
    photo(Camera(eye, sphere.center, {0.1f, 0.2f, 1}, 30), [&](const Ray& ray) {
        Intersection hit;
        if (!sphere.intersect(ray, hit)) return Color();
        ++dimmed.seen;
        if (same(stage.look(ray), shadowless.look(ray))) return Color();
        if (dimmed.wrong++ > 0) return Color();
        dimmed.where = hit.position;
        dimmed.normal = hit.normal;
        dimmed.light = eye;
        dimmed.rays = stage.furtherRays();
        return Color();
    });
}

Dimmed look(float radius, float farAway) {
    Dimmed dimmed;
    for (const Vec3& side : {Vec3(0.48f, 0.6f, 0.64f), Vec3(-0.8f, 0, 0.6f), Vec3(0, -1, 0)}) {
        const Vec3 centre = farAway * side;
        look(thing(centre, radius), centre + 3 * radius * side, dimmed);
    }
    return dimmed;
}

std::string hintFor(const Dimmed& dimmed, float radius) {
    const Ray* ray = shadowRayAmong(dimmed.rays);
    if (!ray) return "";
    const Vec3 start = ray->at(ray->minT) - dimmed.where;
    const bool there = start.norm() < 0.05f * radius;
    if (there && parallel(ray->dir, dimmed.light - dimmed.where))
        return start * dimmed.normal < -1e-4f * radius
                   ? "the shadow ray starts below the surface, which is in its way then: it must "
                     "start a little off, on the side of the normal"
                   : "the surface shadows itself: its points are rounded and lie a little below "
                     "or above it, so the shadow ray must start a little off";
    return wrongWay(*ray, dimmed.where, dimmed.light);
}

// The hint of the first ball along the way to the light that hides it wrongly, or does not.
std::string hintFromBalls() {
    const Shades shades = shadesOf(shown(), {above}, 0);
    for (const float along : {-3.f, 0.75f, 1.5f, 3.f, 4.5f, 6.75f, 12.f}) {
        Stage stage(shown(), {above}, {thing(at(along))});
        const bool hidden = !shades.isLit(stage.look());
        if (hidden != (along > 0 && along < 6))
            return whyWrong(stage.furtherRays(), point, above.position, thing(at(along)), hidden);
    }
    return "";
}

}  // namespace

TEST_CASE("a sphere casts no shadow on its own lit side", "[lab3]") {
    requireShadows();
    for (const auto& [radius, farAway] :
         {std::pair(3.f, 0.f), std::pair(3.f, 25.f), std::pair(11.f, 110.f)}) {
        const Dimmed dimmed = look(radius, farAway);
        if (dimmed.wrong == 0) continue;
        fail({"spheres of radius " + lab::text(radius) + " at a distance of " + lab::text(farAway) +
                  " from (0, 0, 0), each alone with a light",
              std::to_string(dimmed.wrong) + " of " + std::to_string(dimmed.seen) +
                  " lit points are in shadow, as " + lab::text(dimmed.where),
              "none", hintFor(dimmed, radius)});
    }
}

// Only the floor is asked for its colour, and that only for whether the light adds to it. So the
// state of task 1 does not matter.
TEST_CASE("balls over a floor: the picture of light and shadow", "[lab3]") {
    requireShadows();
    const Vec3 eye(1, -9, 9);
    const Light light({3, -2, 8});
    const std::vector<Sphere> balls{thing({-1, 1.5f, 1.5f}, 1.25f), thing({-2, -1.5f, 2.5f}, 0.75f),
                                    thing({2.5f, 1, 0.75f}, 0.75f), thing({4, -2.5f, 10}, 1)};
    const Exposure exposure = shown(light, eye);
    Stage stage(exposure, {light}, balls, eye), lit(exposure, {light}, {}, eye);
    const Image image = photo(Camera(eye, {-1, 0.5f, 0.5f}, {0, 0, 1}, 46), [&](const Ray& ray) {
        Intersection hit;
        if (!stage.meets(ray, hit)) return Color(0.05f, 0.05f, 0.2f);
        if (hit.position[2] != 0) return Color(0.2f, 0.2f, 0.2f);
        return same(stage.look(ray), lit.look(ray)) ? Color(1, 1, 1) : Color(0, 0, 0);
    });
    expectPicture("lab3-shadows", image, 2, 12,
                  {"where the floor is lit (white) and where it is in shadow (black); the balls "
                   "themselves are grey",
                   hintFromBalls()});
}
