#include "lab/depths.h"

using namespace lab;
using namespace sw;

// How often traceRay() calls itself between mirrors.

namespace {

// What a mirrored ray takes away from the depth of a refracted one that is traced after it.
bool reflectionCostsRefraction() {
    const RayCounts alone = countThroughGlass(0, 0.5f), mirrored = countThroughGlass(0.5f, 0.5f);
    for (int depth = 1; depth < 6; ++depth) {
        if (alone.at(depth) != depth + 1 || mirrored.at(depth) != depth / 2 + 1) return false;
    }
    return true;
}

std::string reflectionDepthHint(const RayCounts& found) {
    const std::string hint = depthHint(reflection, found);
    const bool never = found.at(0) == 1 && found.at(1) == RayCounts::endless;
    if (!never || !reflectionCostsRefraction()) return hint;
    return "depth-- hands on the old depth, so that the end is never reached, and takes one from "
           "it only afterwards, for the refracted ray: hand on a number that is one less, and "
           "leave depth itself alone";
}

void expectSameThroughGlass() {
    const RayCounts alone = countThroughGlass(0, 0.5f), mirrored = countThroughGlass(0.5f, 0.5f);
    for (int depth = 5; depth >= 1; --depth) {
        // Where nothing is refracted as soon as something is mirrored, that is task 5's business.
        if (mirrored.at(depth) >= alone.at(depth) || mirrored.at(5) < 2) continue;
        fail({"panes of glass of transparency 0.5 in a row, with depth " + std::to_string(depth) +
                  "; where nothing is mirrored " + countText(alone.at(depth)) + " go down",
              countText(mirrored.at(depth)) + " if half of the light is mirrored", "as many",
              reflectionCostsRefraction()
                  ? "handing on the depth changes it here, so that less of it is left for the "
                    "refracted ray: hand on a number that is one less, and leave depth itself alone"
                  : ""});
    }
}

}  // namespace

TEST_CASE("between two mirrors a ray is followed as often as the depth allows", "[lab4]") {
    const RayCounts found = countBetweenMirrors(1, 0);
    for (int depth = 5; depth >= 1; --depth) {
        if (found.at(depth) == depth + 1) continue;
        fail({"two perfect mirrors face to face, with depth " + std::to_string(depth),
              countText(found.at(depth)),
              std::to_string(depth + 1) + " rays: one from the eye, then one per step of depth",
              reflectionDepthHint(found)});
    }
    expectSameThroughGlass();
}

namespace {

// At depth 0: how it looks, and what it would look like with each mistake.
std::string depth0Hint(const Mix& mix, std::size_t rays) {
    const RayCounts counts = countBetweenMirrors(1, 0);
    if (counts.at(0) != 1) return depthHint(reflection, counts);
    if (const std::string weights = hintFor(reflection, mix); !weights.empty()) return weights;
    if (rays == 1 && agree(mix.got, (1 - mix.w) * mix.scattered + mix.w * sky))
        return "at depth 0 no mirrored ray is traced, so there is nothing to gain: the background "
               "is added here, which no ray has seen";
    if (rays == 1 && agree(mix.got, mix.scattered))
        return "the loss is always due, at depth 0 as well: a mirror scatters no more light "
               "because "
               "no mirrored ray may follow";
    if (rays == 1 && mix.got.isZero() && !mix.scattered.isZero())
        return "black is returned at depth 0, but a surface still shows what it scatters: only the "
               "mirrored ray and the refracted ray are missing";
    return "";
}

}  // namespace

TEST_CASE("at depth 0 a surface shows what it scatters and nothing more", "[lab4]") {
    const bool lit = lightHelps(reflection);
    for (const float r : {0.f, 0.25f, 0.75f}) {
        Painted stage{reflection, 0, lit, true, paint, 4};
        Mix mix{r, stage.seen(), sky, {}, otherWeight(reflection, r), {}};
        stage.depth = 0, stage.weight = r;
        mix.got = stage.seen();
        const Color expected = (1 - r - mix.other) * mix.scattered;
        stage.lit = false;
        stage.seen();  // shadow rays do not count
        const std::size_t rays = stage.rays.size();
        if (agree(mix.got, expected) && rays > 0) continue;
        fail({"a surface of reflectivity " + text(r) + " at depth 0 that scatters " +
                  text(mix.scattered) + " if nothing is mirrored",
              text(mix.got) + (rays == 0 ? ", without a look at the scene" : ""), text(expected),
              depth0Hint(mix, rays)});
    }
}
