#include "swCone.h"

#include <algorithm>

#include "swNumerics.h"

// At height z above the base the radius is R = baseRadius + z tan(slope). Let o and d be the parts
// of the ray's origin and direction across the axis: the ray meets the cone where |o + t d| = R.
// Multiply by cos(slope), which keeps all numbers small for flat cones too. With r = cos(slope) R
// at the origin and its growth s per t, that is
//     a t^2 + 2 b t + c = 0,   a = d^2 - s^2,   b = o d - r s,   c = o^2 - r^2.
// Multiplied out, b^2 - a c is |r d - s o|^2 - |o x d|^2. For a cylinder, s = 0, this is the
// sphere's formula in the plane across the axis, with as little cancellation.

namespace sw {
namespace {

using glm::dvec3;

// A cone with positive radii, in double. The origin is the centre of its base.
struct LateralSurface {
    dvec3 axis;  // unit, from base to apex
    double radius, height, slant;
    double cosine, sine;  // of the slope; sine > 0 where the cone widens
    double extent;        // at least the distance between any two points

    explicit LateralSurface(const Cone& cone) : radius(std::fabs(cone.baseRadius)) {
        const dvec3 way = num::toDouble(cone.apex) - num::toDouble(cone.base);
        const double end = std::fabs(cone.apexRadius), growth = end - radius;
        height = length(way);
        axis = way / height;
        slant = std::sqrt(height * height + growth * growth);
        cosine = height / slant;
        sine = growth / slant;
        extent = height + 2 * std::max(radius, end);
    }

    dvec3 across(const dvec3& v) const { return v - dot(v, axis) * axis; }

    // The cosine times the radius at the height of p. Negative beyond the tip.
    double scaledRadius(const dvec3& p) const { return cosine * radius + sine * dot(p, axis); }

    // How far up the slant, from the base's rim, the surface point next to p lies.
    double upTheSlant(const dvec3& p) const {
        return cosine * dot(p, axis) + sine * (length(across(p)) - radius);
    }

    bool holds(const dvec3& p, double slack) const {
        const double up = upTheSlant(p);
        return up >= -slack && up <= slant + slack && scaledRadius(p) >= -slack;
    }

    // Unit vector from the axis towards p. On the axis, any direction across it will do.
    dvec3 outwards(const dvec3& p) const {
        const dvec3 way = across(across(p));  // twice: near a tip, the first is mostly rounding
        if (dot(way, way) > 0) return normalize(way);
        return normalize(cross(axis, std::fabs(axis.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    }
};

bool hasSurface(const Cone& cone, const LateralSurface& surface) {
    const double r = cone.baseRadius, q = cone.apexRadius;
    return r * q >= 0 && r + q != 0 && std::isfinite(surface.extent) && surface.height > 0;
}

// Where a ray enters and leaves the endless cone. NaN: nowhere.
struct Crossings {
    double entry = NAN, exit = NAN;
};

Crossings crossings(const LateralSurface& surface, const dvec3& origin, const dvec3& direction) {
    const dvec3 o = surface.cosine * surface.across(origin);
    const dvec3 d = surface.cosine * surface.across(direction);
    const double r = surface.scaledRadius(origin), s = surface.sine * dot(direction, surface.axis);
    const double fromAxis = length(o), speed = length(d);
    const double a = (speed - s) * (speed + s);
    const double b = dot(o, d) - r * s;
    const double c = (fromAxis - r) * (fromAxis + r);

    double discriminant = b * b - a * c;
    if (a * c > 0) {
        const dvec3 v = r * d - s * o, x = cross(o, d);
        discriminant = dot(v, v) - dot(x, x);
    }
    if (a < 0) discriminant = std::max(discriminant, 0.0);  // steeper than the slope: never misses
    if (!(discriminant >= 0)) return {};                    // miss, or NaN

    // q adds numbers of one sign; the roots are q / a and c / q.
    const double root = std::sqrt(discriminant), q = b >= 0 ? -b - root : -b + root;
    Crossings t = b >= 0 ? Crossings{q / a, c / q} : Crossings{c / q, q / a};
    // A steep ray meets the cone only once; the other root is on its mirror image beyond the tip.
    if (a < 0) (s > 0 ? t.exit : t.entry) = NAN;
    return t;
}

// Fills the record for a hit of `cone` next to p.
void record(const Cone& cone, const LateralSurface& surface, const dvec3& p, bool fromOutside,
            Intersection& hit) {
    const dvec3 d = num::toDouble(hit.ray.dir), outwards = surface.outwards(p);
    dvec3 normal = normalize(surface.cosine * outwards - surface.sine * surface.axis);
    // At a tip, rounding errors may turn it to the wrong side of the ray: mirror it back.
    const double along = dot(normal, d);
    if (fromOutside ? along > 0 : along < 0) normal -= 2 * along / dot(d, d) * d;
    hit.setFace(num::toFloat(normal), fromOutside, cone.baseRadius + cone.apexRadius < 0);

    // From the base up the slant, not along the ray: exact however far the ray came.
    const double up = std::clamp(surface.upTheSlant(p), 0.0, surface.slant);
    const dvec3 onSurface =
        up * surface.cosine * surface.axis + (surface.radius + up * surface.sine) * outwards;
    hit.position = num::toFloat(num::toDouble(cone.base) + onSurface);
    hit.positionError = num::surfaceError(hit.position, static_cast<float>(surface.extent));
}

}  // namespace

bool Cone::intersect(const Ray& ray, Intersection& hit) const {
    const LateralSurface surface(*this);
    if (!hasSurface(*this, surface)) return false;
    const dvec3 d = num::toDouble(ray.dir), f = num::toDouble(ray.orig) - num::toDouble(base);

    // Measured from the ray's point next to the cone, no length is much larger than the cone.
    const double start = dot(0.5 * surface.height * surface.axis - f, d) / dot(d, d);
    const dvec3 origin = f + start * d;
    Crossings t = crossings(surface, origin, d);
    if (std::isnan(t.entry) && std::isnan(t.exit)) return false;  // misses the endless cone
    // Near a tip the radius is much smaller than the cone: solving again from there is more exact.
    if (surface.sine != 0) {
        const double entry = crossings(surface, origin + t.entry * d, d).entry;
        const double exit = crossings(surface, origin + t.exit * d, d).exit;
        if (std::isfinite(entry)) t.entry += entry;
        if (std::isfinite(exit)) t.exit += exit;
    }

    // The ends are longer by the rounding errors, so that no ray slips through a tip or a seam.
    const double slack = 0x1p-48 * (length(f) + surface.extent);
    const auto counts = [&](double after) {
        return ray.contains(static_cast<float>(start + after)) &&
               surface.holds(origin + after * d, slack);
    };
    const bool fromOutside = baseRadius + apexRadius > 0 && counts(t.entry);
    if (!fromOutside && !counts(t.exit)) return false;

    const double after = fromOutside ? t.entry : t.exit;
    hit.hitT = static_cast<float>(start + after);
    hit.material = material;
    hit.ray = ray;
    record(*this, surface, origin + after * d, fromOutside, hit);
    return true;
}

Bounds Cone::bounds() const {
    const dvec3 n = LateralSurface(*this).axis;
    Bounds box;
    for (const bool atBase : {true, false}) {
        const Vec3& center = atBase ? base : apex;
        const double radius = std::fabs(atBase ? baseRadius : apexRadius);
        for (int i = 0; i < 3; ++i) {
            // Along an axis, a circle reaches as far as the other two parts of its normal are long.
            const double reach = radius * std::hypot(n[(i + 1) % 3], n[(i + 2) % 3]);
            const auto low = static_cast<float>(center[i] - reach);
            const auto high = static_cast<float>(center[i] + reach);
            // Rounding may lose half an ulp: one step outwards makes up for it.
            box.min[i] = std::min(box.min[i], std::nextafter(low, -Bounds::infinity));
            box.max[i] = std::max(box.max[i], std::nextafter(high, Bounds::infinity));
        }
    }
    return box;
}

}  // namespace sw
