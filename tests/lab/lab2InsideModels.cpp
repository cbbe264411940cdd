#include <algorithm>
#include <cmath>

#include "lab/triangleModels.h"

using namespace sw;

namespace lab {
namespace {

bool everywhere(float, float) {
    return true;
}
bool unsignedSum(float w, float v) {
    return isInside(std::fabs(w), std::fabs(v));
}

template <int vertex>
Barycentric fromVertex(const Triangle& t, const Vec3& point) {
    return sharesOf(t, point - t.vertices[vertex]);
}

Barycentric fromZero(const Triangle& t, const Vec3& point) {
    return sharesOf(t, point);
}

Barycentric dotProducts(const Triangle& t, const Vec3& point) {
    const Vec3 r = point - t.vertices[0], e = side(t, 1), f = side(t, 2);
    return {r * e / (e * e), r * f / (f * f)};
}

// Inside of the box, as if that were a triangle's inside.
Barycentric inBox(const Triangle& t, const Vec3& point) {
    const Vec3* corner = t.vertices;
    bool in = true;
    for (int i = 0; i < 3; ++i) {
        const float low = std::min({corner[0][i], corner[1][i], corner[2][i]});
        const float high = std::max({corner[0][i], corner[1][i], corner[2][i]});
        in = in && low <= point[i] && point[i] <= high;
    }
    return in ? Barycentric{0, 0} : Barycentric{-1, -1};
}

constexpr const char* lostSigns =
    "v and w have lost their signs: the length of a cross product has none, its dot product with n "
    "has one";
constexpr const char* onlyOneSign =
    "one of v and w has lost its sign: the length of a cross product has none, its dot product "
    "with n has one";
constexpr const char* unasked =
    "one of the three conditions v >= 0, w >= 0 and v + w <= 1 is not asked: each keeps off "
    "another side";
constexpr const char* oneAsked =
    "only one of the three conditions v >= 0, w >= 0 and v + w <= 1 is asked";
constexpr const char* otherVertex =
    "v and w are those of another point: r leads from v0 to Q, and the sides e1 and e2 begin at v0 "
    "as well";

using Models = std::vector<InsideModel>;

// Wrong signs, and wrong sums of signs.
const Models signs = {
    {"inside is taken to be where w is negative: a x b is -(b x a) and a - b is -(b - a), so the "
     "order decides about the sign",
     [](float w, float v) { return isInside(-w, v); }},
    {"inside is taken to be where v is negative: a x b is -(b x a) and a - b is -(b - a), so the "
     "order decides about the sign",
     [](float w, float v) { return isInside(w, -v); }},
    {"inside is taken to be where v and w are negative: a x b is -(b x a) and a - b is -(b - a), "
     "so the order decides about the sign",
     [](float w, float v) { return isInside(-w, -v); }},
    {lostSigns, unsignedSum},
    {onlyOneSign, [](float w, float v) { return isInside(std::fabs(w), v); }},
    {onlyOneSign, [](float w, float v) { return isInside(w, std::fabs(v)); }},
    {"v and w come out multiplied with |n|: above and below the fraction line n has to stand "
     "equally often, and with the same length",
     isInside, 1},
    {"v and w come out multiplied with |n|^2: what they are shares of is missing below the "
     "fraction line",
     isInside, 2},
    {"v and w come out divided by |n|: above and below the fraction line n has to stand equally "
     "often, and with the same length",
     isInside, -1},
    {"v and w come out divided by |n|^2: above and below the fraction line n has to stand equally "
     "often, and with the same length",
     isInside, -2},
    {"v and w come out as areas without a sign: they are shares of an area, and a cross product's "
     "dot product with n keeps the sign",
     unsignedSum, 1},
    {"v and w have lost their signs, and come out multiplied with |n|^2: what they are shares of "
     "is missing below the fraction line",
     unsignedSum, 2},
};

// Conditions left out.
const Models conditions = {
    {"every point of the plane is taken for inside: inside is where v >= 0, w >= 0 and v + w <= 1 "
     "hold all three",
     everywhere},
    {"v and w alone make a parallelogram: the side opposite to the first vertex is where their sum "
     "is 1",
     [](float w, float v) { return w >= 0 && v >= 0 && w <= 1 && v <= 1; }},
    {unasked, [](float w, float v) { return w >= 0 && v >= 0; }},
    {unasked, [](float w, float v) { return w >= 0 && w + v <= 1; }},
    {unasked, [](float w, float v) { return v >= 0 && w + v <= 1; }},
    {oneAsked, [](float w, float) { return w >= 0; }},
    {oneAsked, [](float, float v) { return v >= 0; }},
    {oneAsked, [](float w, float v) { return w + v <= 1; }},
    {"of v and w only w is asked, whether it is from 0 to 1: v has a say as well",
     [](float w, float) { return w >= 0 && w <= 1; }},
    {"of v and w only v is asked, whether it is from 0 to 1: w has a say as well",
     [](float, float v) { return v >= 0 && v <= 1; }},
    {"a point counts as outside only where both v and w are negative or their sum is above 1: one "
     "negative one is enough",
     [](float w, float v) { return !(w < 0 && v < 0) && w + v <= 1; }},
    {"what counts as inside lies beyond the side opposite to the first vertex: towards v0 the sum "
     "v + w gets smaller",
     [](float w, float v) { return w >= 0 && v >= 0 && w + v >= 1; }},
};

// Other coordinates.
const Models coordinates = {
    {"v and w come out equal, both as v: e1 x r makes the one, r x e2 the other",
     [](float, float v) { return isInside(v, v); }},
    {"v and w come out equal, both as w: e1 x r makes the one, r x e2 the other",
     [](float w, float) { return isInside(w, w); }},
    {otherVertex, isInside, 0, fromVertex<1>},
    {otherVertex, isInside, 0, fromVertex<2>},
    {"v and w are those of another point: r leads from v0 to Q, not from (0, 0, 0) to Q", isInside,
     0, fromZero},
    {"the sides are taken head to tail, e2 from v1 to v2: both begin at v0",
     [](float w, float v) { return isInside(w + v, v); }},
    {"the sides are taken head to tail, e1 from v1 to v2: both begin at v0",
     [](float w, float v) { return isInside(-w, w + v); }},
    {"these are the shadows of r on the sides, from dot products: they are v and w only where e1 "
     "and e2 meet at a right angle",
     isInside, 0, dotProducts},
    {"the whole box around the vertices is taken for inside: a triangle fills a part of it",
     isInside, 0, inBox},
};

}  // namespace

bool InsideModel::contains(const Triangle& t, const Vec3& point) const {
    Barycentric p = shares ? shares(t, point) : fromVertex<0>(t, point);
    const float factor = std::pow(normalOf(t).norm(), static_cast<float>(power));
    return holds(factor * p.w, factor * p.v);
}

const Models& insideModels() {
    static const Models models = [] {
        Models joined = {{"", isInside}};
        for (const Models* list : {&signs, &conditions, &coordinates})
            joined.insert(joined.end(), list->begin(), list->end());
        return joined;
    }();
    return models;
}

Barycentric sharesOf(const Triangle& t, const Vec3& r) {
    const Vec3 n = normalOf(t);
    const float square = n * n;
    return {r * (side(t, 2) % n) / square, r * (n % side(t, 1)) / square};
}

}  // namespace lab
