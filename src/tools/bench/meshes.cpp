#include <stdexcept>
#include <utility>

#include "tools/bench/memory.h"
#include "tools/bench/parts.h"
#include "tools/bench/yardstick.h"

namespace bench {
namespace {

constexpr double million = 1e6;

std::size_t trace(const sw::Scene& scene, const std::vector<sw::Ray>& rays, bool any) {
    sw::Intersection hit;
    std::size_t hits = 0;
    for (const sw::Ray& ray : rays) hits += scene.intersect(ray, hit, any);
    return hits;
}

// One model, in our scene and in Embree's.
class Comparison {
public:
    Comparison(const Setup& chosen, const Model& source, Lines& result)
        : setup(chosen),
          model(source),
          lines(result),
          name(model.name + ", " + std::to_string(model.size())),
          embree(makeYardstick(model)) {}

    void build() {
        const OneProcessor onlyOne;
        std::optional<std::size_t> before, after;
        const auto ours = [&] {
            scene = sw::Scene();
            before = allocatedBytes();
            scene = sceneOf(model);
            const double seconds = processorSecondsOf([&] { scene.prepare(); });
            after = allocatedBytes();
            return seconds;
        };
        if (!embree) {
            ours();
        } else {
            const int repetitions = setup.repetitions(model.size() < 500000 ? 5 : 3);
            const Times times(repetitions,
                              {ours, [&] { return processorSecondsOf([&] { embree->build(); }); }});
            add("build, 1 thread", "Embree", "s", times.of(0), times.of(1), times.ratio(0, 1),
                Target{Target::atMost, 2});
        }
        if (before && after) compareBytes(*after - *before);
    }

    void traceRays(const std::string& kind, const std::vector<sw::Ray>& rays) {
        if (!embree) return;
        for (const bool any : {false, true}) {
            std::size_t found[2] = {};
            const Times times(
                setup.repetitions(7),
                {[&] { return processorSecondsOf([&] { found[0] = trace(scene, rays, any); }); },
                 [&] { return processorSecondsOf([&] { found[1] = embree->trace(rays, any); }); }});
            requireSameHits(found[0], found[1], rays.size());
            const double count = static_cast<double>(rays.size()) / million;
            add(kind + (any ? ", any hit" : ", closest hit"), "Embree", "Mray/s",
                count / times.of(0), count / times.of(1), times.ratio(1, 0),
                Target{Target::atLeast, 1});
        }
    }

private:
    void compareBytes(std::size_t ours) {
        const double each = static_cast<double>(ours) / static_cast<double>(model.size());
        if (!model.triangles.empty())
            add("memory", "the budget", "bytes each", each, 130, each / 130,
                Target{Target::atMost, 1});
        if (!embree) return;
        const double theirs =
            static_cast<double>(embree->bytes()) / static_cast<double>(model.size());
        add("memory", "Embree", "bytes each", each, theirs, each / theirs, std::nullopt);
    }

    void add(const std::string& what, const std::string& other, const std::string& unit,
             double ours, double theirs, double ratio, std::optional<Target> target) {
        lines.push_back({name + ": " + what, other, unit, ours, theirs, ratio, target});
    }

    // Embree computes in float: at edges it may find a few hits more or less.
    void requireSameHits(std::size_t ours, std::size_t theirs, std::size_t rays) const {
        const std::size_t more = std::max(ours, theirs) - std::min(ours, theirs);
        if (more > rays / 500)
            throw std::runtime_error(name + ": we find " + std::to_string(ours) +
                                     " hits and Embree " + std::to_string(theirs));
    }

    const Setup& setup;
    const Model& model;
    Lines& lines;
    std::string name;
    sw::Scene scene;
    std::unique_ptr<Yardstick> embree;
};

}  // namespace

void compareModels(const Setup& setup, Lines& lines) {
    const auto primary = primaryRays(setup.quick ? 64 : 512);
    const auto random = randomRays(setup.quick ? 1 << 12 : 1 << 18);
    const auto compare = [&](const Model& model) {
        Comparison comparison(setup, model, lines);
        comparison.build();
        comparison.traceRays("primary", primary);
        comparison.traceRays("random", random);
    };
    const std::uint32_t small = setup.quick ? 1000 : 100000;
    compare(triangleSoup(small));
    compare(bumpySphere(setup.quick ? 16 : 158));
    if (!setup.quick) compare(bumpySphere(500));
    if (setup.full) compare(bumpySphere(1000));
    compare(sphereflake(small));
}

}  // namespace bench
