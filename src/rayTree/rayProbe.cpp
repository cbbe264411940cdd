#include "rayTree/rayProbe.h"

#include <bit>
#include <cstdint>

namespace rayTree {
namespace {

using namespace sw;

struct TooManyRays {};

using Answers = std::function<Answer(std::size_t, const Ray&)>;

// Replaces all primitives of a scene. For one thread.
class Probe : public Primitive {
public:
    Probe(const Scene& real, Answers givenAnswers, std::vector<Query>& record)
        : scene(real), answers(std::move(givenAnswers)), queries(record) {}

    bool intersect(const Ray& ray, Intersection& hit) const override {
        if (queries.size() == mostRays) throw TooManyRays();
        const Answer answer = answers ? answers(queries.size(), ray) : Answer::truth;
        Query& query = queries.emplace_back();
        query.ray = ray;
        query.isHit = scene.intersect(ray, query.hit);
        if (background) *background = answer == Answer::whiteNothing ? Color(1, 1, 1) : Color();
        if (answer != Answer::truth || !query.isHit) return false;
        hit = query.hit;
        return true;
    }

    Color* background = nullptr;  // if not null, set with every answer

private:
    const Scene& scene;
    const Answers answers;
    std::vector<Query>& queries;
};

Run call(const Trace& trace, const Ray& ray, const Scene& stage, int depth,
         std::vector<Query>& queries) {
    Run run;
    try {
        run.color = trace(ray, stage, depth);
    } catch (const TooManyRays&) {  // which leaves no color
    }
    run.queries = std::move(queries);
    return run;
}

bool isSame(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

}  // namespace

Run watch(const Trace& trace, const Ray& ray, const Scene& scene, int depth) {
    std::vector<Query> queries;
    Scene stage;
    stage.push(std::make_shared<Probe>(scene, nullptr, queries));
    for (const Light& light : scene.lights()) stage.push(light);
    stage.setBackground(scene.background());
    return call(trace, ray, stage, depth, queries);
}

Run replay(const Trace& trace, const Ray& ray, const Scene& scene, int depth,
           const std::vector<Light>& lights, const Answers& answer) {
    std::vector<Query> queries;
    const auto probe = std::make_shared<Probe>(scene, answer, queries);
    Scene stage;
    stage.push(probe);
    for (const Light& light : lights) stage.push(light);
    // Not setBackground(): copies of the scene that the function made would not see it.
    probe->background = const_cast<Color*>(&stage.background());
    return call(trace, ray, stage, depth, queries);
}

bool isSame(const Vec3& a, const Vec3& b) {
    return isSame(a[0], b[0]) && isSame(a[1], b[1]) && isSame(a[2], b[2]);
}

bool isSame(const Ray& a, const Ray& b) {
    return isSame(a.orig, b.orig) && isSame(a.dir, b.dir) && isSame(a.minT, b.minT) &&
           isSame(a.maxT, b.maxT) && a.kind == b.kind;
}

}  // namespace rayTree
