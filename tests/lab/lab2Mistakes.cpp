#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lab/triangleModels.h"

using namespace sw;

namespace lab {
namespace {

// A whole intersection, with a mistake in some steps or in none.
struct Theory {
    const PlaneModel* plane = &planeModels().front();
    const RangeModel* range = &rangeModels().front();
    const SideModel* sides = &sideModels().front();
    const InsideModel* inside = &insideModels().front();

    bool saysHit(const Asked& a) const {
        const bool front = normalOf(a.shape) * a.ray.dir < 0;
        return (front ? sides->fromFront : sides->fromBehind) && range->holds(plane->t(a), a.ray) &&
               inside->contains(a.shape, plane->pointOf(a));
    }

    int mistakes() const {
        return (*plane->hint != 0) + (*range->hint != 0) + (*sides->hint != 0) +
               (*inside->hint != 0);
    }
};

// The mistakes of a theory one by one.
std::vector<Theory> partsOf(const Theory& theory) {
    std::vector<Theory> parts(4);
    parts[0].sides = theory.sides;
    parts[1].plane = theory.plane;
    parts[2].range = theory.range;
    parts[3].inside = theory.inside;
    std::erase_if(parts, [](const Theory& part) { return part.mistakes() == 0; });
    return parts;
}

std::string hintOf(const Theory& part) {
    return std::string(part.sides->hint) + part.plane->hint + part.range->hint + part.inside->hint;
}

std::vector<bool> answersToProbes() {
    std::vector<bool> answers;
    for (const Asked& probe : probes()) answers.push_back(isHit(probe.shape, probe.ray));
    return answers;
}

bool explains(const Theory& theory, const std::vector<bool>& answers) {
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (theory.saysHit(probes()[i]) != answers[i]) return false;
    return true;
}

// The one with fewest mistakes, at most two, that answers everything as the student's code does.
std::optional<Theory> theoryFor(const Asked& asked, bool hit, const std::vector<bool>& answers) {
    for (const int mistakes : {0, 1, 2})
        for (const SideModel& sides : sideModels())
            for (const PlaneModel& plane : planeModels())
                for (const RangeModel& range : rangeModels())
                    for (const InsideModel& inside : insideModels()) {
                        const Theory theory{&plane, &range, &sides, &inside};
                        if (theory.mistakes() == mistakes && theory.saysHit(asked) == hit &&
                            explains(theory, answers))
                            return theory;
                    }
    return {};
}

// From one at least; and whatever t counts.
bool isRightFromOneSide(const std::vector<bool>& answers) {
    for (const SideModel& sides : sideModels())
        for (const RangeModel& range : rangeModels())
            if (explains({&planeModels().front(), &range, &sides, &insideModels().front()},
                         answers))
                return true;
    return false;
}

// All that is computed from a triangle and a ray is, but for fixed numbers, the same at each size
// or grows by a power of it; by a power of 2 even bit for bit.
std::string whyAtThisSizeOnly(const Asked& asked) {
    int exponent = 0;
    std::frexp(side(asked.shape, 1).norm(), &exponent);
    if (exponent == 3) return "";  // from 4 to 8
    const Asked ordinary = scaled(asked, std::ldexp(1.f, 3 - exponent));
    return isHit(ordinary.shape, ordinary.ray) == shouldHit(asked) ? absoluteEpsilon : "";
}

// Roundings are far smaller.
bool agree(const Vec3& a, const Vec3& b) {
    return isNear(a, b, 1e-3f * (1 + b.norm()));
}

bool hitsPlain(const Barycentric& place, float height = 4) {
    return isHit(plainTriangle(), rayTo(plainTriangle(), place, {0, 0, height}));
}

// With v = -w, or the like, nothing but a line through v0 is inside.
bool hitsLineAlone(const Barycentric& along) {
    for (const float far : {3.f, -2.f}) {
        const Barycentric on{far * along.w, far * along.v};
        if (!hitsPlain(on) || hitsPlain({on.w + 0.25f * along.v, on.v + 0.25f * along.w}))
            return false;
    }
    return true;
}

// Whether a statement holds for all that the student's code takes for a hit.
template <typename Statement>
bool allHits(const Statement& holds) {
    for (const Asked& probe : probes()) {
        Intersection hit;
        if (probe.shape.intersect(probe.ray, hit) && !holds(probe, hit)) return false;
    }
    return true;
}

}  // namespace

Barycentric placeOf(const Triangle& shape, const Vec3& point) {
    return sharesOf(shape, point - shape.vertices[0]);
}

bool shouldHit(const Asked& asked) {
    return Theory().saysHit(asked);
}

Asked scaled(const Asked& asked, float factor) {
    Asked other = asked;
    for (Vec3& vertex : other.shape.vertices) vertex *= factor;
    other.ray.orig *= factor;
    other.ray.dir *= factor;
    return other;
}

std::string whyNeverHit() {
    for (const Asked& probe : probes())
        if (isHit(probe.shape, probe.ray)) return "";
    if (hitsPlain({0.25f, 0.25f}) || hitsPlain({0.25f, 0.25f}, -4)) return "";
    for (const auto& [name, along] : {std::pair{"e1", Barycentric{1, 0}}, {"e2", {0, 1}}})
        if (hitsLineAlone(along))
            return std::string("only points of the line along ") + name +
                   " are taken for inside: e1 belongs into one cross product with r, e2 into the "
                   "other";
    return "intersect() returned false for every ray tried: as the starter does";
}

void requireHits() {
    const Barycentric place{0.25f, 0.25f};
    if (hitsPlain(place) || hitsPlain(place, -4)) return;
    const Asked front = askedTo(plainTriangle(), place, {0, 0, 4});
    fail({"rays at a right angle to " + text(front.shape) + ", from both sides to (1, 1, 0)",
          "no hit", "hits at t = 1", whyWrong(front)});
}

std::string faultOfHit(const Intersection& hit) {
    const std::string fault = faultOf(Vec3(hit.hitT, 0, 0));
    return fault.empty() ? faultOf(hit.position) : fault;
}

std::string whyWrong(const Asked& asked) {
    const bool hit = isHit(asked.shape, asked.ray);
    if (const std::string never = hit ? "" : whyNeverHit(); !never.empty()) return never;
    const std::vector<bool> answers = answersToProbes();
    if (std::count(answers.begin(), answers.end(), true) < 10) return "";  // they tell too little
    if (const std::optional<Theory> theory = theoryFor(asked, hit, answers))
        for (const Theory& part : partsOf(*theory))
            if (part.saysHit(asked) == hit) return hintOf(part);
    return isRightFromOneSide(answers) ? whyAtThisSizeOnly(asked) : "";
}

std::string whyOtherT(const Asked& asked, float hitT) {
    for (const PlaneModel& model : planeModels()) {
        const auto yields = [&](const Asked& a, float got) {
            return agree(Vec3(got, 0, 0), Vec3(model.t(a), 0, 0));
        };
        if (yields(asked, hitT) &&
            allHits([&](const Asked& a, const Intersection& hit) { return yields(a, hit.hitT); }))
            return model.hint;
    }
    return "";
}

std::string whyElsewhere(const Asked& asked, const Vec3& position) {
    std::vector<PlaneModel> models = planeModels();
    models.push_back({"the position is counted from v0: it has to be counted from (0, 0, 0)",
                      planeModels().front().t,
                      [](const Asked& a, float t) { return a.ray.at(t) - a.shape.vertices[0]; }});
    for (const PlaneModel& model : models) {
        const auto yields = [&](const Asked& a, const Vec3& got) {
            return agree(got, model.pointOf(a));
        };
        if (yields(asked, position) && allHits([&](const Asked& a, const Intersection& hit) {
                return yields(a, hit.position);
            }))
            return model.hint;
    }
    return "";
}

}  // namespace lab
