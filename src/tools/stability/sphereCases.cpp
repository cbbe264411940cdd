#include "tools/common/random.h"
#include "tools/stability/cases.h"

namespace report {
namespace {

using sw::num::toDouble;
using sw::num::toFloat;

using SphereCase = Case<sw::Sphere>;
using Recipe = SphereCase (*)(double low, double high);

SphereCase judged(const sw::Sphere& sphere, const sw::Ray& ray) {
    return {sphere, ray, exactHit(sphere, ray)};
}

sw::Sphere sphereOf(double radius) {
    return {toFloat(inCube(2 * radius)), static_cast<float>(radius), sw::Material()};
}

// A ray that starts `distance` radii from the centre and passes it at about `impact` radii.
SphereCase aimed(const sw::Sphere& sphere, double distance, double impact) {
    const dvec3 towards = direction();
    const dvec3 aside = perpendicular(towards);
    const double r = sphere.radius;
    const dvec3 origin = toDouble(sphere.center) + r * (impact * aside - distance * towards);
    return judged(sphere, {toFloat(origin), toFloat(towards)});
}

// Half of a disc of sqrt(2) radii is the sphere.
double anyImpact() {
    return std::sqrt(between(0, 2));
}

SphereCase distant(double low, double high) {
    const double impact = anyImpact();
    const double distance = magnitude(low, high);
    return aimed(sphereOf(1), distance, impact);
}

// Passes the silhouette at a distance of low .. high radii, inside or outside.
SphereCase tangent(double low, double high) {
    const double miss = magnitude(low, high);
    const double impact = sw::uniform() < 0.5f ? 1 - miss : 1 + miss;
    const double distance = magnitude(2, 100);
    return aimed(sphereOf(1), distance, impact);
}

// Starts below the surface by low .. high radii.
SphereCase inside(double low, double high) {
    const sw::Sphere sphere = sphereOf(magnitude(0.01, 100));
    const double height = sphere.radius * (1 - magnitude(low, high));
    const dvec3 origin = toDouble(sphere.center) + height * direction();
    return judged(sphere, {toFloat(origin), toFloat(direction())});
}

SphereCase sized(double low, double high) {
    const double impact = anyImpact();
    const double distance = magnitude(2, 100);
    return aimed(sphereOf(magnitude(low, high)), distance, impact);
}

Family<sw::Sphere> family(const std::string& name, Recipe recipe, double low, double high,
                          int size) {
    Family<sw::Sphere> result{name, {}};
    sw::seedPixel(1, 0, 0);
    while (result.cases.size() < static_cast<std::size_t>(size)) {
        const SphereCase candidate = recipe(low, high);
        if (candidate.truth.certain) result.cases.push_back(candidate);
    }
    return result;
}

}  // namespace

std::vector<Family<sw::Sphere>> sphereFamilies(int size) {
    std::vector<Family<sw::Sphere>> families;
    families.push_back(family("ordinary", distant, 2, 10, size));
    for (int k = 1; k < 7; ++k)
        families.push_back(family("distance 1e" + std::to_string(k), distant, std::pow(10, k),
                                  std::pow(10, k + 1), size));
    families.push_back(family("tangent", tangent, 1e-12, 1e-3, size));
    families.push_back(family("inside", inside, 1e-6, 1, size));
    families.push_back(family("tiny", sized, 1e-18, 1e-6, size));
    families.push_back(family("huge", sized, 1e6, 1e18, size));
    return families;
}

}  // namespace report
