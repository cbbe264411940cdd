#pragma once

#include <vector>

#include "swScene.h"

/// What the scenes of several tests are made of.
namespace test {

/// A material that can be recognised in a hit record.
inline sw::Material number(int id) {
    return sw::Material(sw::Color(static_cast<float>(id), 0, 0));
}
inline int numberOf(const sw::Intersection& hit) {
    return static_cast<int>(hit.material.color[0]);
}

/// The number of the primitive that a ray hits; -1: none.
inline int hitBy(const sw::Scene& scene, const sw::Ray& ray, bool any = false) {
    sw::Intersection hit;
    return scene.intersect(ray, hit, any) ? numberOf(hit) : -1;
}

/// The kind of primitive that a student writes: it overrides intersect() alone. The plane at a
/// given z, which fills the record before it knows whether the ray's interval holds the hit.
class Plane : public sw::Primitive {
public:
    Plane(float z, const sw::Material& material) : Primitive(material), z(z) {}
    bool intersect(const sw::Ray& ray, sw::Intersection& hit) const override {
        hit.hitT = (z - ray.orig[2]) / ray.dir[2];
        hit.position = ray.at(hit.hitT);
        hit.frontFacing = ray.dir[2] < 0;
        hit.normal = sw::Vec3(0, 0, hit.frontFacing ? 1.f : -1.f);
        hit.material = material;
        hit.ray = ray;
        return ray.contains(hit.hitT);
    }

private:
    float z;
};

/// Claims a hit at whatever t it was told.
class Claim : public sw::Primitive {
public:
    explicit Claim(float t) : Primitive(number(99)), claimed(t) {}
    bool intersect(const sw::Ray&, sw::Intersection& hit) const override {
        hit.hitT = claimed;
        hit.material = material;
        return true;
    }

private:
    float claimed;
};

/// Is never hit, but remembers every ray that asked. For one thread.
class Recorder : public sw::Primitive {
public:
    bool intersect(const sw::Ray& ray, sw::Intersection&) const override {
        rays.push_back(ray);
        return false;
    }

    mutable std::vector<sw::Ray> rays;
};

/// A triangle at height z that covers some 9 units around the z axis. Its front is up.
inline sw::Triangle tile(float z, const sw::Material& material) {
    const sw::Vec3 corners[] = {{-40, -20, z}, {40, -20, z}, {0, 40, z}};
    return {corners, material};
}

/// How many primitives of a kind are in a scene.
inline std::size_t countOf(const sw::Scene& scene, const std::string& kind) {
    for (const auto& [name, count] : scene.parts().counts)
        if (name == kind) return count;
    return 0;
}

}  // namespace test
