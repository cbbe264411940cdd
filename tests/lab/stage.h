#pragma once

#include <memory>

#include "lab/bendModels.h"
#include "lab/mirrorModels.h"

/// What tasks 4 and 5 have in common: a surface loses a part w of what it scatters and gains w of
/// what another ray brings.
namespace lab {

const float glassIndex = 1.3f;
const sw::Color paint(0.9f, 0.5f, 0.2f);

/// Not above the origin, so that rays from there can be told from those of the hit.
const sw::Vec3 eye(20, -10, 50);
const sw::Ray fromEye(eye, {0, 0, -1});

/// Is met by rays from afar only, not by those that start at its surface, on whichever side.
class FarPane : public Pane {
public:
    using Pane::Pane;
    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        return Pane::intersect(ray, hit) && (hit.position - ray.at(ray.minT)).norm() > 10;
    }
};

/// A black pane that the eye's rays meet plumb. It is turned so that a ray which it mirrors, if
/// some program does so without being asked, leaves sideways and meets nothing.
class DarkPane : public Pane {
public:
    DarkPane(float z, float facing) : Pane(z, facing, opaque()) {}
    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        const bool met = Pane::intersect(ray, hit);
        hit.normal = unit({1, 0, hit.normal[2]});
        return met;
    }
};

/// One of the two, and its words.
struct Gain {
    bool mirrored;      ///< else refracted
    std::string light;  ///< "mirrored": of the light, and of the ray that brings it
    std::string weight, part;

    float way() const { return mirrored ? 1.f : -1.f; }
    sw::Material surface(float w, const sw::Color& color) const {
        return mirrored || w == 0 ? opaque(w, color) : glass(w, glassIndex, color);
    }
};

inline const Gain reflection{true, "mirrored", "reflectivity", "that it mirrors"};
inline const Gain refraction{false, "refracted", "transparency", "that gets through"};

/// A painted surface at height 0 and an eye above it. The ray of this task sees the sky, the other
/// task's ray a black pane: so that task's mistakes change next to nothing.
struct Painted {
    const Gain& gain;
    float weight = 1;
    bool lit = false;                        ///< by a light at the eye
    bool otherDark = true;                   ///< the black pane is there
    sw::Color color = paint;                 ///< of the surface
    int depth = 4;                           ///< more than is needed, as it is not asked about here
    mutable std::vector<sw::Ray> rays = {};  ///< that the scene was asked about

    sw::Color seen() const {
        World world = build();
        const sw::Color got = world.colorOf(fromEye, depth);
        rays = world.rays();
        return got;
    }
    /// What the other task's ray finds.
    sw::Color behind() const {
        return build().colorOf(
            {eye + sw::Vec3(0, 0, gain.mirrored ? -60.f : 1.f), {0, 0, -gain.way()}}, depth);
    }

private:
    World build() const {
        World world;
        world.scene.push(std::make_shared<FarPane>(0.f, 1.f, gain.surface(weight, color)));
        if (lit) world.push(sw::Light(eye, {1, 1, 1}));
        if (otherDark) world.scene.push(std::make_shared<DarkPane>(-100 * gain.way(), gain.way()));
        return world;
    }
};

/// The ray that the student's function makes for the eye's ray and a surface.
inline sw::Ray ownRay(const Gain& gain, bool mirrored) {
    sw::Intersection hit;
    Pane(0, 1, gain.surface(0.5f, {0, 0, 0})).intersect(fromEye, hit);
    return mirrored ? hit.getReflectedRay() : hit.getRefractedRay();
}

/// That ray, or what is traced in its place because a surface has a weight; null if nothing is.
inline std::unique_ptr<sw::Ray> followed(const Gain& gain) {
    const Painted with{gain, 0.5f}, without{gain, 0};
    with.seen(), without.seen();
    const sw::Vec3 own = ownRay(gain, gain.mirrored).dir;
    for (std::size_t i = 1; i < with.rays.size(); ++i)
        if (agree(with.rays[i].dir, own)) return std::make_unique<sw::Ray>(with.rays[i]);
    if (with.rays.size() <= without.rays.size() || with.rays.size() < 2) return nullptr;
    for (const sw::Ray& ray : with.rays)
        if (std::none_of(without.rays.begin(), without.rays.end(), [&](const sw::Ray& old) {
                return alike(ray.dir, old.dir) && alike(ray.orig, old.orig);
            }))
            return std::make_unique<sw::Ray>(ray);
    return std::make_unique<sw::Ray>(with.rays.back());
}

inline bool isTraced(const Gain& gain) {
    return followed(gain) != nullptr;
}

/// True if that ray starts where the eye's ray hits the surface and goes where it has to.
inline bool followsRightly(const Gain& gain) {
    const auto ray = followed(gain);
    return ray != nullptr && noRayHint(*ray).empty() && ray->maxT > 1e6f &&
           agree(heading(ray->dir), {0, 0, gain.way()}) &&
           alike(startOf(*ray), {eye[0], eye[1], 0}, 0.05f);
}

/// Why another ray is followed than the one that is due.
inline std::string wrongRayHint(const Gain& gain, const sw::Ray& ray) {
    if (const std::string hint = noRayHint(ray); !hint.empty()) return hint;
    const sw::Ray own = ownRay(gain, gain.mirrored), other = ownRay(gain, !gain.mirrored);
    const std::string instead = ": follow the " + gain.light + " one";
    if (agree(ray.dir, own.dir))
        return gain.mirrored ? mirrorHint(own, {fromEye.dir, {0, 0, 1}})
                             : bendHint(own, {fromEye.dir, {0, 0, 1}, glassIndex, true});
    if (agree(heading(ray.dir), fromEye.dir))
        return "the ray that traceRay() follows is the one that came in" + instead;
    if (agree(ray.dir, other.dir))
        return "the ray that traceRay() follows is the one of the other task" + instead;
    return "";
}

/// A surface that does only what the other task is about: its light must not come by this one's
/// ray.
inline bool takesOtherWeight(const Gain& gain) {
    World world;
    world.push(
        Pane(0, 1, sw::Material({0, 0, 0}, gain.mirrored ? 0 : 0.5f, gain.mirrored ? 0.5f : 0, 1)));
    world.colorOf(fromEye, 4);
    return std::any_of(world.rays().begin() + 1, world.rays().end(),
                       [&](const sw::Ray& ray) { return ray.dir[2] * gain.way() > 0; });
}

/// True if a thing under a light is seen by this task's ray, so that only the sky gets lost.
inline bool losesSky(const Gain& gain) {
    const float way = gain.way();
    const auto seen = [&](float w, const sw::Ray& ray) {
        World world;
        world.push(Pane(0, 1, gain.surface(w, {0, 0, 0})));
        world.push(Pane(100 * way, -way, opaque(0, {0.3f, 0.2f, 0.8f})));
        world.push(sw::Light({eye[0], eye[1], 30 * way}, {1, 1, 1}));
        return world.colorOf(ray, 4);
    };
    const sw::Color thing = seen(0, {{eye[0], eye[1], 60 * way}, {0, 0, way}}),
                    own = seen(0, fromEye);
    if (agree(thing, own)) return false;
    return agree(seen(0.5f, fromEye), 0.5f * (own + thing));
}

/// Why nothing of what this task's ray sees arrives.
inline std::string nothingHint(const Gain& gain) {
    const std::string ray = gain.light + " ray";
    if (const auto traced = followed(gain); traced != nullptr) {
        if (!followsRightly(gain)) return wrongRayHint(gain, *traced);
        return losesSky(gain) ? "a " + ray +
                                    " that hits nothing brings the background, as a ray from the "
                                    "eye does, but here that gets lost"
                              : "a " + ray + " is traced, but what it brings gets lost";
    }
    if (takesOtherWeight(gain))
        return "the " + (gain.mirrored ? refraction : reflection).weight + " is taken for the " +
               gain.weight + " here";
    return "nothing of what the " + ray +
           " sees arrives, as none is traced: traceRay() has to ask itself for it";
}

}  // namespace lab
