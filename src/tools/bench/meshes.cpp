#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "tools/bench/memory.h"
#include "tools/bench/parts.h"
#include "tools/bench/yardstick.h"

namespace bench {
namespace {

using Rays = std::vector<sw::Ray>;

std::size_t trace(const sw::Scene& scene, std::span<const sw::Ray> rays, bool any) {
    sw::Intersection hit;
    std::size_t hits = 0;
    for (const sw::Ray& ray : rays) hits += any ? scene.isOccluded(ray) : scene.intersect(ray, hit);
    return hits;
}

// Something to compare with, and how fast we aim to be.
struct Other {
    const char* name;
    std::unique_ptr<Yardstick> yardstick;
    double target;
};

// Embree, and for triangles also its mode that promises what we promise: no ray slips through.
std::vector<Other> othersFor(const Model& model) {
    std::vector<Other> others;
    const bool balls = !model.balls.empty();
    others.push_back({"Embree", makeYardstick(model, false), balls ? 1 : 0.85});
    if (!others[0].yardstick) return {};
    if (!balls) others.push_back({"Embree, watertight", makeYardstick(model, true), 1});
    return others;
}

// One model, in our scene and in Embree's.
class Comparison {
public:
    Comparison(const Setup& chosen, const Model& source, bool inCache, Lines& result)
        : setup(chosen),
          model(source),
          isLarge(!inCache),
          lines(result),
          name(model.name + ", " + std::to_string(model.size())),
          others(othersFor(model)) {}

    void build() {
        const OneProcessor onlyOne;
        std::optional<std::size_t> before, after;
        std::vector<std::function<double()>> contestants{[&] {
            scene = sw::Scene();
            before = allocatedBytes();
            scene = sceneOf(model);
            const double seconds = processorSecondsOf([&] { scene.prepare(); });
            after = allocatedBytes();
            return seconds;
        }};
        for (const Other& other : others)
            contestants.push_back(
                [&] { return processorSecondsOf([&] { other.yardstick->build(); }); });
        const Times times(setup.repetitions(model.size() < 500000 ? 5 : 3), contestants);
        if (!isLarge) return;
        if (!others.empty())
            add("build, 1 thread", "Embree", "s", times.of(0), times.of(1), times.ratio(0, 1),
                Target{Target::atMost, 2});
        if (before && after) compareBytes(*after - *before);
    }

    void traceRays(const std::string& kind, const Rays& rays) {
        if (others.empty()) return;
        Rays parts[2];  // misses, hits
        sw::Intersection hit;
        for (const sw::Ray& ray : rays) parts[scene.intersect(ray, hit)].push_back(ray);
        for (const bool any : {false, true}) traceParts(kind, parts, any);
    }

private:
    // Contestant 2i, 2i + 1: misses and hits of ours (i = 0) and of the others.
    void traceParts(const std::string& kind, const Rays (&parts)[2], bool any) {
        std::vector<std::size_t> found(2 * others.size() + 2);
        std::vector<std::function<double()>> contestants;
        for (std::size_t i = 0; i < found.size(); ++i)
            contestants.push_back([this, i, any, &found, &rays = parts[i % 2]] {
                return processorSecondsOf([&] {
                    found[i] = i < 2 ? trace(scene, rays, any)
                                     : others[i / 2 - 1].yardstick->trace(rays, any);
                });
            });
        Times times(setup.repetitions(7), contestants);
        const std::size_t ours = times.sum(0, 1), rays = parts[0].size() + parts[1].size();
        const auto ratioOf = [&](std::size_t i, std::size_t part) {
            return parts[part].size() < 1000 ? std::nullopt
                                             : std::optional(times.ratio(i + part, part));
        };
        for (std::size_t k = 0; k < others.size(); ++k) {
            const std::size_t i = 2 * k + 2, all = times.sum(i, i + 1);
            requireSameHits(found[1], found[i] + found[i + 1], rays);
            const double count = static_cast<double>(rays) / 1e6;
            add(kind + (any ? ", any hit" : ", closest hit"), others[k].name, "Mray/s",
                count / times.of(ours), count / times.of(all), times.ratio(all, ours),
                isLarge ? std::optional(Target{Target::atLeast, others[k].target}) : std::nullopt);
            lines.back().misses = ratioOf(i, 0);
            lines.back().hits = ratioOf(i, 1);
        }
    }

    void compareBytes(std::size_t ours) {
        const double each = static_cast<double>(ours) / static_cast<double>(model.size());
        constexpr double budget = 70;
        if (!model.triangles.empty())
            add("memory", "the budget", "bytes each", each, budget, each / budget,
                Target{Target::atMost, 1});
        if (others.empty()) return;
        const double theirs =
            static_cast<double>(others[0].yardstick->bytes()) / static_cast<double>(model.size());
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
    bool isLarge;  // models in the cache have no targets
    Lines& lines;
    std::string name;
    sw::Scene scene;
    std::vector<Other> others;
};

}  // namespace

void compareModels(const Setup& setup, Lines& lines) {
    const auto primary = primaryRays(setup.quick ? 64 : 512);
    const auto random = randomRays(setup.quick ? 1 << 12 : 1 << 18);
    const auto compare = [&](const Model& model, bool inCache = false) {
        Comparison comparison(setup, model, inCache, lines);
        comparison.build();
        comparison.traceRays("primary", primary);
        comparison.traceRays("random", random);
    };
    const std::uint32_t many = setup.quick ? 1000 : 100000;
    compare(bumpySphere(16), true);
    compare(triangleSoup(many));
    if (!setup.quick) compare(bumpySphere(158));
    if (!setup.quick) compare(bumpySphere(500));
    if (setup.full) compare(bumpySphere(1000));
    compare(sphereflake(many));
}

}  // namespace bench
