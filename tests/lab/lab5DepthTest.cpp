#include "lab/depths.h"

using namespace lab;
using namespace sw;

// How often traceRay() calls itself through glass. Task 4 may end all recursion too early: task 5
// is judged from the least depth on at which a ray is traced at all.

namespace {

// What a refracted ray takes away from the depth of a mirrored one that is traced after it.
void expectSameBetweenMirrors() {
    const RayCounts alone = countBetweenMirrors(0.5f, 0);
    const RayCounts refracted = countBetweenMirrors(0.5f, 0.5f);
    for (int depth = 5; depth >= 1; --depth) {
        // Where nothing is mirrored as soon as something is refracted, that is task 4's business.
        if (refracted.at(depth) >= alone.at(depth) || refracted.at(5) < 2) continue;
        const bool halved = alone.at(5) == 6 && refracted.at(5) == 3 && refracted.at(4) == 3 &&
                            refracted.at(3) == 2;
        fail({"two mirrors face to face, with depth " + std::to_string(depth) +
                  "; where nothing is refracted there are " + countText(alone.at(depth)) +
                  " between them",
              countText(refracted.at(depth)) + " if half of the light gets through", "as many",
              halved ? "handing on the depth changes it here, so that less of it is left for the "
                       "mirrored ray: hand on a number that is one less, and leave depth itself "
                       "alone"
                     : ""});
    }
}

}  // namespace

TEST_CASE("a ray goes through as many panes as the depth allows", "[lab5]") {
    const RayCounts found = countThroughGlass(0, 0.5f);
    const int lost = found.lost();
    for (int depth = 5; depth >= lost; --depth) {
        const int expected = depth - lost + 1;
        if (found.at(depth) == expected) continue;
        fail({"panes of glass in a row, with depth " + std::to_string(depth),
              countText(found.at(depth)), countText(expected), depthHint(refraction, found, lost)});
    }
    expectSameBetweenMirrors();
}

namespace {

std::string lastHint(const Mix& mix, int depth) {
    const RayCounts counts = countThroughGlass(0, 0.5f);
    if (counts.at(depth) != 1) return depthHint(refraction, counts, depth);
    if (const std::string weights = hintFor(refraction, mix); !weights.empty()) return weights;
    if (agree(mix.got, (1 - mix.w) * mix.scattered + mix.w * sky))
        return "without any depth left no refracted ray is traced, so there is nothing to gain: "
               "the "
               "background is added here, which no ray has seen";
    if (agree(mix.got, mix.scattered))
        return "the loss is always due, without any depth left as well: glass scatters no more "
               "light because no refracted ray may follow";
    return "";
}

}  // namespace

TEST_CASE("without any depth left glass shows what it scatters and nothing more", "[lab5]") {
    const int depth = countThroughGlass(0, 0).lost();
    // What task 4 may return for a ray before it is traced.
    const Color untraced = depth > 0 ? World().colorOf({{}, {0, 0, -1}}, depth - 1) : Color();
    const bool lit = lightHelps(refraction);
    for (const float t : {0.25f, 0.75f}) {
        Painted stage{refraction, 0, lit, true, paint, 4};
        Mix mix{t, stage.seen(), sky, {}, otherWeight(refraction, t), {}};
        stage.depth = depth, stage.weight = t;
        mix.got = stage.seen();
        const Color expected = (1 - t - mix.other) * mix.scattered + (t + mix.other) * untraced;
        if (agree(mix.got, expected)) continue;
        fail({"a surface of transparency " + text(t) + " at depth " + std::to_string(depth) +
                  " that scatters " + text(mix.scattered) + " if it is opaque",
              text(mix.got), text(expected), lastHint(mix, depth)});
    }
}
