#include <utility>

#include "tools/stability/floats.h"
#include "tools/stability/methods.h"

namespace report {
namespace {

using sw::Sphere;

// The two values of t where a line meets a sphere, entry first.
struct Roots {
    float entry, exit;
};

// The original: a t^2 + b t + c = 0 by the textbook formula. If the sphere is far away, b^2 and 4ac
// are huge and nearly equal, and so are -b and the square root.
bool floatQuadratic(const Sphere& sphere, const Ray& ray, Roots& roots) {
    const Vec3 f = ray.orig - sphere.center;
    const float a = ray.dir * ray.dir;
    const float b = 2 * (f * ray.dir);
    const float c = f * f - sphere.radius * sphere.radius;
    const float discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return false;
    const float root = std::sqrt(discriminant);
    roots = {(-b - root) / (2 * a), (-b + root) / (2 * a)};
    return true;
}

// Adds only numbers of the same sign; the other root follows from the product of the roots.
// halfB is -f * d, the discriminant that of a t^2 - 2 halfB t + c.
void stableRoots(float a, float halfB, float c, float discriminant, Roots& roots) {
    const float q = halfB + std::copysign(std::sqrt(discriminant), halfB);
    roots = {q / a, c / q};
    if (!std::signbit(halfB)) std::swap(roots.entry, roots.exit);
}

// x y - z w with an error of at most 1.5 ulp (Kahan; see Jeannerod, Louvet and Muller, Further
// Analysis of Kahan's Algorithm, Math. Comp. 2013). On targets without FMA
// instructions std::fma is a call, which takes most of this method's time.
float differenceOfProducts(float x, float y, float z, float w) {
    const float zw = z * w;
    return std::fma(x, y, -zw) + std::fma(-z, w, zw);
}

// Kahan, On the Cost of Floating-Point Computation Without Extra-Precise Arithmetic, 2004. It
// solves the given equation accurately, but a, b and c are already rounded.
bool kahan(const Sphere& sphere, const Ray& ray, Roots& roots) {
    const Vec3 f = ray.orig - sphere.center;
    const float a = ray.dir * ray.dir;
    const float halfB = -(f * ray.dir);
    const float c = f * f - sphere.radius * sphere.radius;
    const float discriminant = differenceOfProducts(halfB, halfB, a, c);
    if (!(discriminant >= 0)) return false;
    stableRoots(a, halfB, c, discriminant, roots);
    return true;
}

// Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, ch. 7: the
// vector from the sphere's centre to the nearest point of the line gives the discriminant.
bool haines(const Sphere& sphere, const Ray& ray, Roots& roots) {
    const Vec3 f = ray.orig - sphere.center;
    const float a = ray.dir * ray.dir;
    const float halfB = -(f * ray.dir);
    const Vec3 nearest = f + ray.dir * (halfB / a);
    const float discriminant = a * (sphere.radius * sphere.radius - nearest * nearest);
    if (!(discriminant >= 0)) return false;
    stableRoots(a, halfB, f * f - sphere.radius * sphere.radius, discriminant, roots);
    return true;
}

template <bool (*solve)(const Sphere&, const Ray&, Roots&)>
class FloatSphere : public Sphere {
public:
    explicit FloatSphere(const Sphere& sphere) : Sphere(sphere) {}

    bool intersect(const Ray& ray, Intersection& hit) const override {
        Roots roots;
        if (!solve(*this, ray, roots)) return false;
        const bool front = ray.contains(roots.entry);
        if (!front && !ray.contains(roots.exit)) return false;
        const float t = front ? roots.entry : roots.exit;
        const Vec3 position = ray.at(t);
        fill(hit, ray, t, position, position - center, front, 2 * radius, material);
        return true;
    }
};

template <typename Kernel>
std::unique_ptr<sw::Primitive> make(const Sphere& sphere) {
    return std::make_unique<Kernel>(sphere);
}

}  // namespace

std::vector<Method<Sphere>> sphereMethods() {
    return {{"float quadratic (original)", make<FloatSphere<floatQuadratic>>},
            {"Kahan's roots", make<FloatSphere<kahan>>},
            {"Haines' discriminant", make<FloatSphere<haines>>},
            {"ours", make<Sphere>}};
}

}  // namespace report
