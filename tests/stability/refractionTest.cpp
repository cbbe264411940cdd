// The oracle takes the float inputs as they are, makes normal and direction unit in exact
// arithmetic and applies Snell's law as vectors: sin(out) = |n x T| = eta |n x d|. T is rounded to
// float, at most u/2 per component, so |n x T| is off by less than u; 8u max(1, eta) is the issue's
// bound. Total internal reflection is decided by the sign of 1 - eta^2 |n x d|^2, which double
// precision can miss within a few 2^-53 of 0 and must not miss beyond 2^-48. Rounded inputs need no
// band.

#include "stability/cases.h"
#include "stability/exact.h"
#include "swIntersection.h"

using namespace sw;
using namespace test;
using exact::Real;
using exact::Real3;

namespace {

float anyIndex(Random& random) {
    if (random.coin()) return random.real(1 / 2.5, 2.5);
    const double nearOne = random.magnitude(1e-7, 1e-6);
    return static_cast<float>(random.coin() ? 1 + nearOne : 1 - nearOne);
}

double etaOf(const Intersection& hit) {
    const double index = hit.material.refractiveIndex;
    return hit.frontFacing ? 1 / index : index;
}

// From straight on to grazing; half of them near the critical angle where there is one.
double anyAngle(Random& random, double eta) {
    const double right = std::acos(0.0);
    if (!(eta > 1) || random.coin()) return random.uniform(0, right);
    const double critical = std::asin(1 / eta), away = random.magnitude(1e-9, 1e-1);
    return std::fmin(right * 0.9999, random.coin() ? critical * (1 + away) : critical * (1 - away));
}

Intersection randomHit(Random& random) {
    Intersection hit;
    hit.position = random.point(10);
    hit.normal = anyDirection(random);
    hit.frontFacing = random.coin();
    hit.material.refractiveIndex = anyIndex(random);
    hit.positionError = 1e-5f;
    const double angle = anyAngle(random, etaOf(hit));
    const dvec3 n = toDouble(hit.normal), side = toDouble(across(random, hit.normal));
    const dvec3 d = std::sin(angle) * side - std::cos(angle) * n;
    const double length = random.coin() ? 1 : random.magnitude(1e-20, 1e20);
    hit.ray.dir = sw::num::toFloat(length * d);
    return hit;
}

std::string show(const Intersection& hit) {
    return describe("d", hit.ray.dir, "n", hit.normal, "index", hit.material.refractiveIndex,
                    hit.frontFacing ? "entering" : "leaving");
}

bool sameRay(const Ray& a, const Ray& b) {
    return distance(a.orig, b.orig) == 0 && distance(a.dir, b.dir) == 0;
}

std::string judgeRefraction(const Intersection& hit, const Ray& out) {
    const Real3 n = exact::unit(Real3(hit.normal)), d = exact::unit(Real3(hit.ray.dir));
    const Real index = hit.material.refractiveIndex, eta = hit.frontFacing ? 1 / index : index;
    const Real3 sine = cross(n, d);
    const Real c = 1 - eta * eta * dot(sine, sine);
    const bool reflected = sameRay(out, hit.getReflectedRay());
    if (exact::abs(exact::length(Real3(out.dir)) - 1) > 4 * u) return "direction not unit";
    if (c < -0x1p-48) return reflected ? "" : "no total reflection";
    if (c > 0x1p-48 && reflected) return "total reflection that should not be";
    if (reflected) return "";
    const Real3 residual = cross(n, Real3(out.dir)) - eta * sine;
    const double size = static_cast<double>(exact::length(residual));
    if (size > 8 * u * std::fmax(1, static_cast<double>(eta)))
        return describe("Snell's residual is", size / u, "u");
    if (dot(n, Real3(out.dir)) > 2 * u) return "on the wrong side";
    if (dot(n, Real3(out.orig) - Real3(hit.position)) > 0) return "starts on the wrong side";
    return "";
}

// One exact step from d at n against what the library made of it.
std::string judgeReflection(const Vec3& normal, const Vec3& in, const Vec3& out) {
    const Real3 n = exact::unit(Real3(normal)), d = exact::unit(Real3(in)), r(out);
    const Real length = exact::abs(exact::length(r) - 1), angle = exact::abs(dot(n, r) + dot(n, d));
    const Real plane = exact::length(cross(n, r) - cross(n, d));
    const Real largest = exact::max(length, exact::max(angle, plane));
    if (largest <= 2 * u) return "";
    return describe("off by", static_cast<double>(largest) / u, "u: d", in, "n", normal);
}

Vec3 reflected(const Vec3& normal, const Vec3& d) {
    Intersection hit;
    hit.normal = normal * d > 0 ? -normal : normal;
    hit.ray.dir = d;
    hit.positionError = 0;
    return hit.getReflectedRay().dir;
}

}  // namespace

TEST_CASE("refraction obeys Snell's law and reflects totally exactly when it should") {
    int total = 0;
    checkRandomCases(8 * familySize, [&](Random& random) {
        const Intersection hit = randomHit(random);
        const Ray out = hit.getRefractedRay();
        total += sameRay(out, hit.getReflectedRay());
        const std::string problem = judgeRefraction(hit, out);
        return problem.empty() ? problem : problem + " " + show(hit);
    });
    CHECK(total > familySize / 2);
}

TEST_CASE("a reflection keeps length and angle and plane") {
    checkRandomCases(familySize, [](Random& random) {
        const Intersection hit = randomHit(random);
        return judgeReflection(hit.normal, hit.ray.dir, hit.getReflectedRay().dir);
    });
}

TEST_CASE("a thousand reflections keep length and angle and plane") {
    // Between two parallel mirrors the angle to their normal, and the part of the direction along
    // them, must stay what they were.
    checkRandomCases(familySize, [](Random& random) {
        const Vec3 normal = anyDirection(random), start = random.direction();
        Vec3 d = start;
        for (int i = 0; i < 1000; ++i) d = reflected(normal, d);
        const Real3 n = exact::unit(Real3(normal)), first = exact::unit(Real3(start)), last(d);
        const Real length = exact::abs(exact::length(last) - 1);
        const Real angle = exact::abs(dot(n, last) - dot(n, first));
        const Real plane = exact::length(cross(n, last) - cross(n, first));
        const Real largest = exact::max(length, exact::max(angle, plane));
        if (largest <= 16 * u) return std::string();
        return describe("off by", static_cast<double>(largest) / u, "u: d", start, "n", normal);
    });
}
