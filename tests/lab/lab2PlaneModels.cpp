#include <cmath>

#include "lab/triangleModels.h"

using namespace sw;

namespace lab {
namespace {

// Of the plane from the ray's origin; positive if the ray runs with the normal towards it.
float signedDistance(const Asked& a) {
    return a.t * (normalOf(a.shape).normalize() * a.ray.dir);
}

// The t of the parallel plane through (0, 0, 0).
float tThroughZero(const Asked& a) {
    const Vec3 n = normalOf(a.shape);
    return a.t - n * a.shape.vertices[0] / (n * a.ray.dir);
}

float rightT(const Asked& a) {
    return a.t;
}

const std::vector<PlaneModel> planes = {
    {"", rightT},
    {"t comes out with the opposite sign: what lies ahead of the ray's origin has a positive t",
     [](const Asked& a) { return -a.t; }},
    {"t comes out positive even where the plane lies behind the ray's origin: a sign is lost",
     [](const Asked& a) { return std::fabs(a.t); }},
    {"t comes out as if n . d had no sign: seen from the other side of the plane, both parts of "
     "the quotient change theirs",
     [](const Asked& a) { return normalOf(a.shape) * a.ray.dir < 0 ? -a.t : a.t; }},
    {"this t is n . (v0 - o) alone: one step of d covers n . d of it, so how many steps are "
     "needed?",
     [](const Asked& a) { return a.t * (normalOf(a.shape) * a.ray.dir); }},
    {"this t is the distance of the plane, or that with a minus sign: t counts the steps of d that "
     "lead to the plane",
     signedDistance},
    {"this t is the distance of the plane, or that with a minus sign: t counts the steps of d that "
     "lead to the plane",
     [](const Asked& a) { return -signedDistance(a); }},
    {"this t is a distance: t says how often the direction, as long as it is, has to be added to "
     "the origin",
     [](const Asked& a) { return a.t * a.ray.dir.norm(); },
     [](const Asked& a, float) { return a.ray.at(a.t); }},
    {"this t is 1 / t: the way to the plane is divided by the part of it that one step of d covers",
     [](const Asked& a) { return 1 / a.t; }},
    {"t comes out multiplied with |n|: above and below the fraction line, n has to be of the same "
     "length",
     [](const Asked& a) { return a.t * normalOf(a.shape).norm(); }},
    {"t comes out divided by |n|: above and below the fraction line, n has to be of the same "
     "length",
     [](const Asked& a) { return a.t / normalOf(a.shape).norm(); }},
    {"this t leads to a plane through (0, 0, 0): the plane of the triangle goes through v0",
     tThroughZero},
    {"the point lies t steps of length 1 from the ray's origin: t counts steps of d, as long as d "
     "is",
     rightT, [](const Asked& a, float t) { return a.ray.orig + t * Vec3(a.ray.dir).normalize(); }},
    {"the point is o + d, whatever t is: t says how often d has to be added", rightT,
     [](const Asked& a, float) { return a.ray.orig + a.ray.dir; }},
    {"the point is t d, counted from (0, 0, 0): the ray begins at o", rightT,
     [](const Asked& a, float t) { return t * a.ray.dir; }},
};

}  // namespace

const std::vector<PlaneModel>& planeModels() {
    return planes;
}

const std::vector<RangeModel>& rangeModels() {
    static const std::vector<RangeModel> models = {
        {"", [](float t, const Ray& ray) { return ray.minT < t && t < ray.maxT; }},
        {"a hit counts only before maxT: shadow rays end at the light, and nearer things hide "
         "others",
         [](float t, const Ray& ray) { return ray.minT < t; }},
        {"a hit counts only after minT, which need not be 0: what leaves a surface must not meet "
         "it again",
         [](float t, const Ray& ray) { return 0 < t && t < ray.maxT; }},
        {"every t before maxT counts here: a ray begins at minT, and what lies before that it does "
         "not meet",
         [](float t, const Ray& ray) { return t < ray.maxT; }},
        {"neither minT nor maxT is asked: a hit counts only between them",
         [](float t, const Ray&) { return 0 < t; }},
        {"every t counts here, even a negative one: a hit counts only between minT and maxT",
         [](float, const Ray&) { return true; }},
        {"t is equal to minT here, and a hit counts only where t is greater",
         [](float t, const Ray& ray) { return ray.minT <= t && t < ray.maxT; }},
    };
    return models;
}

const std::vector<SideModel>& sideModels() {
    static const char* both =
        "a triangle is hit from both sides: whether the ray runs with the normal or against it "
        "only decides about frontFacing";
    static const std::vector<SideModel> models = {
        {"", true, true}, {both, true, false}, {both, false, true}};
    return models;
}

}  // namespace lab
