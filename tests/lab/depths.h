#pragma once

#include "lab/gains.h"

/// How far traceRay() follows rays, as a function of the depth.
namespace lab {

/// The rays that were traced with depths 0, 1, 2 ...
struct RayCounts {
    static constexpr int endless = 1000;  ///< so many at most
    std::vector<int> counts;

    /// Depths at which traceRay() traces nothing at all. If there are any, that is task 4's
    /// business: task 5 begins behind them.
    int lost() const {
        int depth = 0;
        while (depth < static_cast<int>(counts.size()) && at(depth) == 0) ++depth;
        return depth;
    }
    int at(int depth) const { return counts[static_cast<std::size_t>(depth)]; }
};

/// Counts the rays of a world that `counted` is true of.
template <typename Counted>
RayCounts countRays(const World& world, const sw::Ray& first, const Counted& counted) {
    constexpr int depths = 6;
    RayCounts all;
    for (int depth = 0; depth < depths; ++depth) {
        World asked = world;
        sw::Color color;
        const bool ends = asked.trace(first, depth, color);
        const auto sum = std::count_if(asked.rays().begin(), asked.rays().end(), counted);
        all.counts.push_back(ends ? static_cast<int>(sum) : RayCounts::endless);
    }
    return all;
}

/// Mirrors at z = 0 and z = 100, face to face; some light may go through them.
inline RayCounts countBetweenMirrors(float r, float t) {
    const sw::Material half({0, 0, 0}, r, t, t > 0 ? glassIndex : 1e-6f);
    World world;
    world.push(Pane(0, 1, half));
    world.push(Pane(100, -1, half));
    return countRays(world, fromEye, [](const sw::Ray& ray) {
        const bool up = ray.orig[2] < 50 && ray.dir[2] > 0;
        const bool down = ray.orig[2] >= 50 && ray.dir[2] < 0;
        return (up || down) && !isEmpty(ray);
    });
}

/// Panes of glass one below the other, ten apart.
inline World panes(int count, const sw::Material& material) {
    World world;
    for (int i = 0; i < count; ++i) world.push(Pane(-10.f * static_cast<float>(i), 1, material));
    return world;
}

/// The rays that go down through many panes, more than any depth that is asked for.
inline RayCounts countThroughGlass(float r, float t) {
    constexpr int many = 400;
    const World world = panes(many, {{0, 0, 0}, r, t, glassIndex});
    RayCounts all = countRays(world, fromEye,
                              [](const sw::Ray& ray) { return ray.dir[2] < 0 && !isEmpty(ray); });
    for (int& count : all.counts)
        if (count > many) count = RayCounts::endless;
    return all;
}

/// The depth that a level has, and the rays with it: what a mistake makes of them.
struct DepthSuspect {
    std::function<int(int depth)> yields;
    std::string hint;
};

inline std::vector<DepthSuspect> depthSuspects(const Gain& gain) {
    const std::string ray = gain.light + " ray";
    const int endless = RayCounts::endless;
    return {
        {[](int) { return 1; }, ""},  // none is traced: see nothingHint()
        {[=](int) { return endless; },
         "the recursion has no end: nothing asks whether there is any depth left before the " +
             ray + " is traced, and at depth 0 no more rays may follow"},
        {[=](int depth) { return depth == 0 ? 1 : endless; },
         "the depth never gets less: each call hands on what it was given itself, so that the end "
         "is never reached; one less is left for each " +
             ray},
        {[](int depth) { return depth; },
         "one level too few: at depth 0 traceRay() asks the scene for nothing, but a ray of depth "
         "0 "
         "is traced as well, and only those that would follow it are not"},
        {[](int depth) { return std::max(1, depth); },
         "one level too few: with depth 1 there is one " + ray},
        {[](int depth) { return depth + 2; },
         "one level too many: with depth 0 there is no " + ray + " yet, with depth 1 there is one"},
        {[](int depth) { return (depth + 1) / 2 + 1; },
         "the depth gets less by 2 with each " + ray + ", not by 1"},
        {[](int depth) { return depth == 0 ? 1 : 2; },
         "no " + ray +
             " is followed by another one, as if it were handed a depth of 0: it is handed "
             "one less than there was"},
        {[](int depth) { return (1 << (depth + 1)) - 1; },
         "at each hit two " + ray +
             "s are traced, so their number doubles with every step of "
             "depth: trace one and keep the colour that it brings"},
        {[](int depth) {
             const int threes[] = {1, 4, 13, 40, 121, 364};
             return threes[depth];
         },
         "at each hit three " + ray +
             "s are traced, so their number is tripled by every step of "
             "depth: trace one and keep the colour that it brings"}};
}

/// Why the number of rays is wrong. Empty if it is right, or if no mistake explains all numbers.
inline std::string depthHint(const Gain& gain, const RayCounts& found, int lost = 0) {
    const int depths = static_cast<int>(found.counts.size()) - lost;
    for (const DepthSuspect& suspect : depthSuspects(gain)) {
        bool guilty = depths > 3;
        for (int depth = 0; depth < depths; ++depth)
            guilty &= found.at(depth + lost) == suspect.yields(depth);
        if (!guilty) continue;
        if (suspect.hint.empty()) return nothingHint(gain);
        return followsRightly(gain) ? suspect.hint : "";
    }
    return "";
}

inline std::string countText(int rays) {
    return rays == RayCounts::endless ? "rays without end"
                                      : std::to_string(rays) + (rays == 1 ? " ray" : " rays");
}

}  // namespace lab
