#include "accel/bvhTraversal.h"
#include "tools/bench/models.h"
#include "tools/bench/parts.h"

namespace bench {
namespace {

struct Growth {
    std::size_t triangles = 0;
    double nanoseconds = 0;  // per random ray
    double nodes = 0;        // visited by a random ray
};

double nanosecondsPerRay(const sw::Scene& scene, const std::vector<sw::Ray>& rays) {
    sw::Intersection hit;
    const double seconds = processorSecondsOf([&] {
        for (const sw::Ray& ray : rays) scene.intersect(ray, hit);
    });
    return seconds * 1e9 / static_cast<double>(rays.size());
}

// Counted with a Bvh built like the scene's.
double nodesPerRay(const Model& model, const std::vector<sw::Ray>& rays) {
    std::vector<sw::Bounds> boxes;
    boxes.reserve(model.size());
    for (std::size_t i = 0; i < model.size(); ++i) boxes.push_back(model.triangle(i).bounds());
    const sw::Bvh tree(boxes);
    std::uint64_t nodes = 0;
    for (const sw::Ray& ray : rays) {
        sw::Ray rest = ray;
        sw::Intersection hit;
        const auto leaf = [&](std::uint32_t first, std::uint32_t count, float& limit) {
            for (const std::uint32_t i : tree.order().subspan(first, count))
                if (model.triangle(i).intersect(rest, hit)) rest.maxT = hit.hitT;
            limit = sw::widened(rest.maxT);
            return false;
        };
        nodes += tree.traverse(ray, leaf).nodes;
    }
    return static_cast<double>(nodes) / static_cast<double>(rays.size());
}

std::string count(std::size_t n) {
    return std::to_string(n) + " triangles";
}

}  // namespace

void measureGrowth(const Setup& setup, Lines& lines) {
    std::vector<std::uint32_t> sizes{16, 50, 158, 500};
    if (setup.quick) sizes.resize(2);
    if (setup.full) sizes.push_back(1581);
    const auto rays = randomRays(setup.quick ? 1 << 12 : 1 << 17);
    const auto few = randomRays(1 << 12);

    std::vector<sw::Scene> scenes;
    std::vector<Growth> growth;
    for (const std::uint32_t n : sizes) {
        const Model model = bumpySphere(n);
        scenes.push_back(sceneOf(model));
        scenes.back().prepare();
        growth.push_back({model.size(), 0, nodesPerRay(model, few)});
    }
    std::vector<std::function<double()>> contestants;
    for (const sw::Scene& scene : scenes)
        contestants.push_back([&] { return nanosecondsPerRay(scene, rays); });
    const Times times(setup.repetitions(7), contestants);
    for (std::size_t k = 1; k < growth.size(); ++k) {
        const bool aim = growth[k].triangles == 1000000;
        lines.push_back({"growth, " + count(growth[k].triangles) + ": time of a random ray",
                         count(growth[0].triangles), "ns", times.of(k), times.of(0),
                         times.ratio(k, 0),
                         aim ? std::optional(Target{Target::atMost, 6}) : std::nullopt});
        lines.push_back(
            {"growth, " + count(growth[k].triangles) + ": nodes visited by a random ray",
             count(growth[0].triangles), "nodes", growth[k].nodes, growth[0].nodes,
             growth[k].nodes / growth[0].nodes});
    }
}

}  // namespace bench
