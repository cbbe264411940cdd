#include "rayTree/rayProbe.h"

#include <bit>
#include <cstdint>

namespace rayTree {
namespace {

using namespace sw;

struct TooManyRays {};

bool isSame(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

}  // namespace

// Replaces all primitives of a scene.
class Stage::Probe : public Primitive {
public:
    bool intersect(const Ray& ray, Intersection& hit) const override {
        const Query* const truth = answer(ray);
        if (!truth || !truth->isHit) return false;
        hit = truth->hit;
        return true;
    }

    std::function<const Query*(const Ray&)> answer;
};

Stage::Stage(const Scene& realScene) : real(realScene), probe(std::make_shared<Probe>()) {
    scene.push(probe);
    for (const Light& light : real.lights()) scene.push(light);
}

// Not setBackground(), nor push() for lights: copies of the scene that the function made would not
// see it.
Color& Stage::background() {
    return const_cast<Color&>(scene.background());
}

void Stage::shine(int light) {
    for (std::size_t i = 0; i < real.lights().size(); ++i) {
        const bool shines = light == allLights || light == static_cast<int>(i);
        const_cast<Light&>(scene.lights()[i]).color = shines ? real.lights()[i].color : Color();
    }
}

template <typename Answer>
std::optional<Color> Stage::call(const Trace& trace, const Ray& ray, int depth, std::size_t most,
                                 const Answer& truth) {
    std::size_t number = 0;
    probe->answer = [&](const Ray& next) {
        if (number == most) throw TooManyRays();
        ++asked;
        return truth(number++, next);
    };
    try {
        return trace(ray, scene, depth);
    } catch (const TooManyRays&) {
        return std::nullopt;
    }
}

Run Stage::watch(const Trace& trace, const Ray& ray, int depth, std::size_t most) {
    Run run;
    shine(allLights);
    background() = real.background();
    run.color = call(trace, ray, depth, most, [&](std::size_t, const Ray& next) {
        Query& query = run.queries.emplace_back();
        query.ray = next;
        query.isHit = real.intersect(next, query.hit);
        return &query;
    });
    return run;
}

std::optional<Color> Stage::replay(const Trace& trace, const Ray& ray, int depth, int light,
                                   const Answers& answers) {
    shine(light);
    return call(trace, ray, depth, mostRays, [&](std::size_t number, const Ray& next) {
        const Answer answer = answers(number, next);
        background() = answer.isWhite ? Color(1, 1, 1) : Color();
        return answer.truth;
    });
}

bool isSame(const Vec3& a, const Vec3& b) {
    return isSame(a[0], b[0]) && isSame(a[1], b[1]) && isSame(a[2], b[2]);
}

bool isSame(const Ray& a, const Ray& b) {
    return isSame(a.orig, b.orig) && isSame(a.dir, b.dir) && isSame(a.minT, b.minT) &&
           isSame(a.maxT, b.maxT) && a.kind == b.kind;
}

}  // namespace rayTree
