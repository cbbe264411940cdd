#include <memory>
#include <vector>

#include "tools/bench/room.h"
#include "tools/bench/textbook.h"

namespace bench {
namespace {

using namespace textbook;

class Primitive {
public:
    Material material;

    explicit Primitive(const Material& surface) : material(surface) {}
    virtual ~Primitive() = default;
    virtual bool intersect(const Ray& ray, Hit& hit) const = 0;

protected:
    void fill(Hit& hit, const Ray& ray, float t, const Vec3& outward) const {
        hit.hitT = t;
        hit.position = ray.orig + t * ray.dir;
        hit.normal = normalized(outward);
        hit.frontFacing = hit.normal * ray.dir < 0;
        if (!hit.frontFacing) hit.normal = -hit.normal;
        hit.material = material;
        hit.ray = ray;
    }
};

// The textbook quadratic formula.
class Sphere : public Primitive {
public:
    Sphere(const Vec3& middle, float size, const Material& surface)
        : Primitive(surface), center(middle), radius(size) {}

    bool intersect(const Ray& ray, Hit& hit) const override {
        const Vec3 f = ray.orig - center;
        const float a = ray.dir * ray.dir;
        const float b = 2 * (f * ray.dir);
        const float c = f * f - radius * radius;
        const float discriminant = b * b - 4 * a * c;
        if (discriminant < 0) return false;
        const float root = std::sqrt(discriminant);
        float t = (-b - root) / (2 * a);
        if (t <= ray.minT) t = (-b + root) / (2 * a);
        if (t <= ray.minT || t >= ray.maxT) return false;
        fill(hit, ray, t, ray.orig + t * ray.dir - center);
        return true;
    }

private:
    Vec3 center;
    float radius;
};

// First the plane, then the three areas around the hit point, as lengths of cross products.
class Triangle : public Primitive {
public:
    Triangle(const Vec3* v, const Material& surface)
        : Primitive(surface), vertices{v[0], v[1], v[2]} {}

    bool intersect(const Ray& ray, Hit& hit) const override {
        const Vec3 n = (vertices[1] - vertices[0]) % (vertices[2] - vertices[0]);
        const float slope = n * ray.dir;
        if (slope == 0) return false;
        const float t = n * (vertices[0] - ray.orig) / slope;
        if (t <= ray.minT || t >= ray.maxT) return false;
        const Vec3 p = ray.orig + t * ray.dir;
        const float area = norm(n);
        const float u = norm((vertices[2] - vertices[1]) % (p - vertices[1])) / area;
        const float v = norm((vertices[0] - vertices[2]) % (p - vertices[2])) / area;
        const float w = norm((vertices[1] - vertices[0]) % (p - vertices[0])) / area;
        if (u + v + w > 1 + 1e-4f) return false;
        fill(hit, ray, t, n);
        return true;
    }

private:
    Vec3 vertices[3];
};

class Scene {
public:
    Vec3 light;

    explicit Scene(const Vec3& light) : light(light) {}
    void push(std::shared_ptr<Primitive> primitive) { primitives.push_back(std::move(primitive)); }

    bool intersect(const Ray& ray, Hit& hit, bool any = false) const {
        bool found = false;
        Hit candidate;
        for (const auto& primitive : primitives) {
            if (!primitive->intersect(ray, candidate)) continue;
            if (any) return true;
            if (found && candidate.hitT >= hit.hitT) continue;
            hit = candidate;
            found = true;
        }
        return found;
    }

private:
    std::vector<std::shared_ptr<Primitive>> primitives;
};

// Casts every shadow ray, unlike embreePicture.cpp: neither may cost the other time.
// NOLINTNEXTLINE(performance-unnecessary-value-param): as in the original
Vec3 traceRay(const Ray& ray, Scene scene, int depth) {
    if (depth < 0) return {};
    Hit hit;
    if (!scene.intersect(ray, hit)) return {};

    Vec3 direct =
        std::fmax(hit.normal * normalized(scene.light - hit.position), 0.0f) * hit.material.color;
    Hit blocker;
    if (scene.intersect(hit.getShadowRay(scene.light), blocker, true)) direct = Vec3();

    const float r = hit.material.reflectivity, t = hit.material.transparency;
    Vec3 color = (1 - r - t) * direct;
    if (r > 0) color += r * traceRay(hit.getReflectedRay(), scene, depth - 1);
    if (t > 0) color += t * traceRay(hit.getRefractedRay(), scene, depth - 1);
    return color;
}

}  // namespace

Radiance originalsPicture(int size) {
    const Room room = loadRoom();
    Scene scene(room.light);
    for (const sw::Sphere& s : room.spheres)
        scene.push(std::make_shared<Sphere>(s.center, s.radius, s.material));
    for (const sw::Triangle& t : room.triangles)
        scene.push(std::make_shared<Triangle>(t.vertices, t.material));
    return pictureOf(size, [scene](const Ray& ray) { return traceRay(ray, scene, labDepth); });
}

}  // namespace bench
