#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lab/matte.h"
#include "lab/teach.h"
#include "tools/common/mainFunctions.h"

/// What the tests of task 3 share: a floor under lights, and what its point looks like.
namespace lab {

// Not 0: what traceRay() does at the end of the recursion is task 4.
constexpr int fullDepth = 3;

/// The point of the floor that is asked for its colour, and from where.
inline const sw::Vec3 point(5, -7, 0);
inline const sw::Vec3 eyeOfPoint = point + sw::Vec3(-4, 0, 3);

/// A place along the way from the point to the light that `above` is, and beside it.
inline sw::Vec3 at(float along, float beside = 0, float further = 0) {
    return point + along * sw::Vec3(2, -1, 2) * (1 / 3.f) +
           beside * sw::Vec3(2, 2, -1) * (1 / 3.f) + further * sw::Vec3(-1, 2, 2) * (1 / 3.f);
}

inline const sw::Light above(at(6));

/// The rays that a scene is asked about.
using Asked = std::vector<sw::Ray>;

/// The plane z = 0, seen by the eye alone: no light is hidden by it, and a mirrored ray (task 4)
/// never comes back to it. It notes all rays.
class Floor : public sw::Primitive {
public:
    /// @param facing  1: its normal faces upwards; -1: downwards
    Floor(const sw::Vec3& eye, float facing, const std::shared_ptr<Asked>& asked)
        : Primitive(matte({0.75f, 0.5f, 0.25f})), eye(eye), facing(facing), asked(asked) {}

    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        asked->push_back(ray);
        if (!(ray.orig - eye).isZero()) return false;
        hit.hitT = -ray.orig[2] / ray.dir[2];
        hit.position = ray.orig + hit.hitT * ray.dir;
        hit.position[2] = 0;
        hit.frontFacing = true;
        hit.normal = sw::Vec3(0, 0, facing);
        hit.material = material;
        hit.ray = ray;
        return ray.contains(hit.hitT);
    }

private:
    sw::Vec3 eye;
    float facing;
    std::shared_ptr<Asked> asked;
};

/// A sphere that vanishes after so many rays that a recursion without end (task 4) finds one.
class Ball : public sw::Sphere {
public:
    Ball(const sw::Sphere& sphere, const std::shared_ptr<Asked>& asked)
        : Sphere(sphere), asked(asked) {}
    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        constexpr std::size_t most = 200;
        return asked->size() < most && Sphere::intersect(ray, hit);
    }

private:
    std::shared_ptr<Asked> asked;
};

/// How light is made to show. Mostly as it is; but where a mistake in another task leaves the floor
/// black under it, in a way in which such a mistake still makes a difference.
struct Exposure {
    float facing = 1;         ///< of the floor: from where is it lit if the cosine's sign is wrong?
    bool numberless = false;  ///< lights of colour NaN, of which even a factor of 0 leaves a trace
};

/// What there is to say of that in a message.
inline std::string remark(const Exposure& shown) {
    return shown.numberless ? " (the light's colour is NaN, which shows even where task 1 still "
                              "makes black of every other)"
                            : "";
}

/// A floor, lights and things, and the rays asked about since the last look.
class Stage {
public:
    Stage(const Exposure& shown, const std::vector<sw::Light>& lights,
          const std::vector<sw::Sphere>& things, const sw::Vec3& eye = eyeOfPoint)
        : eye(eye) {
        scene.push(std::make_shared<Floor>(eye, shown.facing, rays));
        for (const sw::Sphere& thing : things) scene.push(std::make_shared<Ball>(thing, rays));
        for (sw::Light light : lights) {
            for (float& channel : light.color.m)
                if (shown.numberless && channel > 0)
                    channel = std::numeric_limits<float>::quiet_NaN();
            scene.push(light);
        }
    }

    void push(const std::shared_ptr<sw::Primitive>& primitive) { scene.push(primitive); }

    /// The student's colour of what the eye sees along a ray.
    sw::Color look(const sw::Ray& ray, int depth = fullDepth) {
        rays->clear();
        return traceRay(ray, scene, depth);
    }
    /// Of a point of the floor.
    sw::Color look(int depth = fullDepth) {
        sw::Vec3 along = point - eye;
        return look(sw::Ray(eye, along.normalize()), depth);
    }
    bool meets(const sw::Ray& ray, sw::Intersection& hit) const {
        rays->clear();
        return scene.intersect(ray, hit);
    }

    const std::shared_ptr<Asked>& asked() const { return rays; }
    /// What the last look asked, but for the eye's ray.
    Asked furtherRays() const { return {rays->begin() + (rays->empty() ? 0 : 1), rays->end()}; }

private:
    sw::Vec3 eye;
    std::shared_ptr<Asked> rays = std::make_shared<Asked>();
    sw::Scene scene;
};

/// Rounding plays no part here. What is no number is the same as another such.
inline bool same(const sw::Color& a, const sw::Color& b) {
    for (int i = 0; i < 3; ++i) {
        if (std::isnan(a[i]) && std::isnan(b[i])) continue;
        if (!(a[i] == b[i]) && !(std::fabs(a[i] - b[i]) <= 1e-5f * (1 + std::fabs(b[i]))))
            return false;
    }
    return true;
}

/// What light and shadow look like by the student's own shading (task 1), whatever that is.
struct Shades {
    sw::Color lit;      ///< under all lights
    sw::Color without;  ///< the same without the light in question
    sw::Color unlit;    ///< the same with that light black

    bool isLit(const sw::Color& color) const { return same(color, lit); }
    /// The last two differ where something is added to what lights bring (task 1).
    bool isHidden(const sw::Color& color) const {
        return same(color, without) || (same(color, unlit) && !isLit(unlit));
    }
};

inline Shades shadesOf(const Exposure& shown, std::vector<sw::Light> lights, std::size_t which,
                       int depth = fullDepth) {
    Shades shades;
    shades.lit = Stage(shown, lights, {}).look(depth);
    lights[which].color = sw::Color(0, 0, 0);
    shades.unlit = Stage(shown, lights, {}).look(depth);
    lights.erase(lights.begin() + static_cast<std::ptrdiff_t>(which));
    shades.without = Stage(shown, lights, {}).look(depth);
    return shades;
}

/// A small ball.
inline sw::Sphere thing(const sw::Vec3& centre, float radius = 0.5f) {
    return {centre, radius, matte({1, 1, 1})};
}

/// A way in which this light shows at the point, if there is one.
inline bool findShowing(const sw::Light& light, Exposure& shown, const sw::Vec3& eye = eyeOfPoint) {
    for (const Exposure& next : {Exposure{}, Exposure{-1, false}, Exposure{1, true}}) {
        if (same(Stage(next, {light}, {}, eye).look(), Stage(next, {}, {}, eye).look())) continue;
        shown = next;
        return true;
    }
    return false;
}

/// The same where it is known that there is one, or where nothing depends on it.
inline Exposure shown(const sw::Light& light = above, const sw::Vec3& eye = eyeOfPoint) {
    Exposure best;
    findShowing(light, best, eye);
    return best;
}

}  // namespace lab
