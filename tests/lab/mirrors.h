#pragma once

#include <cfloat>
#include <cmath>
#include <string>
#include <vector>

#include "lab/teach.h"
#include "support.h"
#include "tools/common/mainFunctions.h"

/// What the tests of reflection, refraction and supersampling have in common. Their scenes have a
/// bright sky and (nearly always) no lights, so that shading and shadows play no part in them.
namespace lab {

/// Three channels that cannot be mistaken for each other, nor for multiples of each other.
inline const sw::Color sky(0.9f, 0.7f, 0.4f);

/// A surface that lets nothing through. Its refractive index is next to nothing: whoever takes that
/// for the transparency, a mistake in task 5, hardly sees it here.
inline sw::Material opaque(float reflectivity = 0, const sw::Color& color = sw::Color(0, 0, 0)) {
    return sw::Material(color, reflectivity, 0, 1e-6f);
}

/// Glass that mirrors nothing.
inline sw::Material glass(float transparency, float index,
                          const sw::Color& color = sw::Color(0, 0, 0)) {
    return sw::Material(color, 0, transparency, index);
}

/// A flat piece at height z, as wide as it may be. From behind it cannot be seen: rays go through,
/// so that those of another task, right or wrong, never come back.
class Pane : public sw::Primitive {
public:
    /// @param facing  1: seen from above, by rays with a falling z; -1: from below
    /// @param width   it ends at x = width
    Pane(float z, float facing, const sw::Material& surface, float width = FLT_MAX)
        : Primitive(surface), height(z), front(facing), end(width) {}

    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        if (!(ray.dir[2] * front < 0)) return false;
        hit.hitT = (height - ray.orig[2]) / ray.dir[2];
        hit.position = ray.orig + hit.hitT * ray.dir;
        hit.normal = sw::Vec3(0, 0, front);
        hit.frontFacing = true;
        hit.material = material;
        hit.ray = ray;
        return ray.minT < hit.hitT && hit.hitT < ray.maxT && hit.position[0] < end;
    }

private:
    float height;
    float front;
    float end;
};

/// A scene under the sky in which all rays are seen and no recursion goes on for ever.
class World {
public:
    sw::Scene scene;

    /// @param mostRays  with so many rays a recursion is taken to have no end
    explicit World(int mostRays = 2000) : witness(std::make_shared<RayWitness>(mostRays)) {
        scene.setBackground(sky);
        scene.push(witness);
    }
    void push(const Pane& pane) { scene.push(std::make_shared<Pane>(pane)); }
    void push(const sw::Sphere& sphere) { scene.push(sphere); }
    void push(const sw::Light& light) { scene.push(light); }

    /// Asks the student's traceRay(); `rays` tells later what it asked of the scene.
    /// @return  false where it found no end
    bool trace(const sw::Ray& ray, int depth, sw::Color& color) {
        witness->rays.clear();
        try {
            color = traceRay(ray, scene, depth);
        } catch (const TooManyRays&) {
            return false;
        }
        return true;
    }
    const std::vector<sw::Ray>& rays() const { return witness->rays; }

    /// The same where the test is about something else.
    sw::Color colorOf(const sw::Ray& ray, int depth) {
        sw::Color color;
        if (!trace(ray, depth, color)) {
            fail({"a ray from " + text(ray.orig) + " in direction " + text(ray.dir) +
                      " with depth " + std::to_string(depth),
                  std::to_string(rays().size()) + " rays, and no end of them", "a colour", ""});
        }
        return color;
    }

private:
    std::shared_ptr<RayWitness> witness;
};

/// False where either is not a number.
inline bool alike(const sw::Vec3& a, const sw::Vec3& b, float tolerance = 1e-4f) {
    for (int i = 0; i < 3; ++i) {
        if (!(std::fabs(a[i] - b[i]) <= tolerance)) return false;
    }
    return true;
}

inline bool isNumber(const sw::Vec3& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

inline sw::Vec3 unit(sw::Vec3 v) {
    return v.normalize();
}

/// A ray without a direction, as the starter's getReflectedRay() and getRefractedRay() return it,
/// or without a point.
inline bool isEmpty(const sw::Ray& ray) {
    return ray.dir.isZero() || !(ray.minT < ray.maxT);
}

/// True if exactly one ray followed the last one that the world was asked for, and that ray meets
/// another surface itself.
inline bool goesOnToAnother(World& world) {
    const std::vector<sw::Ray> rays = world.rays();
    if (rays.size() != 2 || isEmpty(rays[1])) return false;
    world.colorOf(rays[1], 9);
    return world.rays().size() > 1;
}

/// What a typical mistake gives, and what to say about it.
struct Guess {
    sw::Vec3 wrong;
    std::string hint;
};

/// The hint of the first guess that gives what came out; none without `otherwise`.
inline std::string hintFor(const sw::Vec3& got, const std::vector<Guess>& guesses,
                           const std::string& otherwise = "") {
    for (const Guess& guess : guesses) {
        if (alike(got, guess.wrong)) return guess.hint;
    }
    return otherwise;
}

/// A unit vector at right angles to another one.
inline sw::Vec3 along(const sw::Vec3& normal, test::Random& random) {
    for (;;) {
        const sw::Vec3 v = normal % random.direction();
        if (v.norm() > 0.1f) return unit(v);
    }
}

/// The hit of a ray with that direction, as a primitive would fill it in.
inline sw::Intersection hitBy(const sw::Vec3& direction, const sw::Vec3& normal,
                              const sw::Material& material, bool frontFacing = true) {
    sw::Intersection hit;
    hit.position = sw::Vec3(1, -2, 3);
    hit.normal = normal;
    hit.hitT = 1;
    hit.frontFacing = frontFacing;
    hit.material = material;
    hit.ray = sw::Ray(hit.position - direction, direction);
    return hit;
}

}  // namespace lab
