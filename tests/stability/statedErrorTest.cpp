// Primitives as students write them, in float and from the slides, state no positionError. The safe
// default must keep the rays that leave them from hitting them again, at every scale, as long as
// the ray came from no farther than some 30 times the primitive's size (see statedOrDefaultError).

#include "stability/cases.h"
#include "swIntersection.h"
#include "swPrimitive.h"

using namespace sw;
using namespace test;

namespace {

// Fills what the slides ask for.
void record(const Ray& ray, float t, const Vec3& outward, const Material& material,
            Intersection& hit) {
    hit.hitT = t;
    hit.position = ray.at(t);
    hit.frontFacing = outward * ray.dir < 0;
    hit.normal = hit.frontFacing ? outward : -outward;
    hit.normal.normalize();
    hit.material = material;
    hit.ray = ray;
}

// The plane, then signed areas.
struct SlideTriangle : Triangle {
    bool intersect(const Ray& ray, Intersection& hit) const override {
        const Vec3 e1 = vertices[1] - vertices[0], e2 = vertices[2] - vertices[0], n = e1 % e2;
        const float t = n * (vertices[0] - ray.orig) / (n * ray.dir);
        if (!ray.contains(t)) return false;
        const Vec3 p = ray.at(t) - vertices[0];
        const float v = (p % e2) * n / (n * n), w = (e1 % p) * n / (n * n);
        if (!(v >= 0 && w >= 0 && v + w <= 1)) return false;
        record(ray, t, n, material, hit);
        return true;
    }
};

// The quadratic formula.
struct SlideSphere : Sphere {
    bool intersect(const Ray& ray, Intersection& hit) const override {
        const Vec3 f = ray.orig - center;
        const float a = ray.dir * ray.dir, b = f * ray.dir, c = f * f - radius * radius;
        const float discriminant = b * b - a * c;
        if (!(discriminant >= 0)) return false;
        for (const float sign : {-1.0f, 1.0f}) {
            const float t = (-b + sign * std::sqrt(discriminant)) / a;
            if (!ray.contains(t)) continue;
            record(ray, t, ray.at(t) - center, material, hit);
            return true;
        }
        return false;
    }
};

SlideTriangle anySlideTriangle(Random& random, float size) {
    SlideTriangle triangle;
    do
        for (Vec3& v : triangle.vertices) v = random.point(size);
    while (((triangle.vertices[1] - triangle.vertices[0]).normalize() %
            (triangle.vertices[2] - triangle.vertices[0]).normalize())
               .norm() < 0.1);
    return triangle;
}

// What is wrong with the rays that leave a hit; those in `inside` must hit the sphere once more.
template <typename Shape>
std::string judge(const Shape& shape, const Ray& ray, const Vec3& light, bool& found) {
    Intersection hit, next;
    found = shape.intersect(ray, hit);
    if (!found) return "";
    if (shape.intersect(hit.getReflectedRay(), next)) return describe("reflected", ray, shape);
    const Vec3 toLight = light - hit.position;
    const float cosine = Vec3(toLight).normalize() * hit.normal;
    const bool blocked = shape.intersect(hit.getShadowRay(light), next);
    if (cosine > 0.01f && blocked) return describe("blocked", ray, shape, light);
    return "";
}

}  // namespace

TEST_CASE("a ray that leaves a triangle from the slides never hits it again") {
    int hits = 0;
    checkRandomCases(3 * familySize, [&](Random& random) {
        const float size = anyScale(random);
        const SlideTriangle triangle = anySlideTriangle(random, size);
        const dvec3 middle = (toDouble(triangle.vertices[0]) + toDouble(triangle.vertices[1]) +
                              toDouble(triangle.vertices[2])) /
                             3.0;
        const Vec3 target = moved(num::toFloat(middle), random.direction(), 0.1 * size);
        const Vec3 from = moved(target, random.direction(), size * random.magnitude(0.1, 30));
        bool found = false;
        const Ray ray(from, (target - from).normalize());
        const std::string problem = judge(triangle, ray, random.point(10) * size, found);
        hits += found;
        return problem;
    });
    CHECK(hits > familySize);
}

TEST_CASE("a ray reflected by a sphere from the slides never hits it again") {
    int hits = 0;
    checkRandomCases(3 * familySize, [&](Random& random) {
        const float size = anyScale(random);
        SlideSphere sphere;
        sphere.radius = size;
        sphere.center = random.point(size);
        const Vec3 target = moved(sphere.center, random.direction(), 0.95 * size);
        const Vec3 from =
            moved(sphere.center, random.direction(), size * random.magnitude(1.1, 30));
        bool found = false;
        const Ray ray(from, (target - from).normalize());
        const std::string problem = judge(sphere, ray, random.point(10) * size, found);
        hits += found;
        return problem;
    });
    CHECK(hits > familySize);
}
