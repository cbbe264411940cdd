#include "rayTree/pixelStudents.h"
#include "tools/common/mainFunctions.h"

// --explore finds a tree for every pixel: what that costs.

using namespace test;
using rayTree::growTree;

TEST_CASE("a tree is found with a few questions for every ray") {
    Random random(GENERATE(range(0u, 60u)));
    const Scene scene = randomRoom(random);
    const int depth = random.whole(0, 5);
    rayTree::Stage stage(scene);
    const rayTree::RayTree tree = growTree(lab::traceRay, randomLook(random), stage, depth, false);
    // A ray is asked for in its own call, in those of the rays above it, and in some replays.
    CAPTURE(stage.asked, tree.nodes, depth);
    CHECK(stage.asked <= static_cast<std::size_t>(depth + 8) * tree.nodes);
}

TEST_CASE("one stage serves for many rays, whatever was asked on it before") {
    Random random(GENERATE(range(0u, 20u)));
    const Scene scene = randomRoom(random);
    rayTree::Stage stage(scene);
    Student endless;
    endless.decreasesDepth = endless.testsDepth = false;
    for (int i = 0; i < 5; ++i) {
        const Ray ray = randomLook(random);
        if (i % 2 == 1) growTree(endless, randomLook(random), stage, 3);
        const auto shared = growTree(lab::traceRay, ray, stage, 3);
        const auto alone = growTree(lab::traceRay, ray, scene, 3);
        CHECK(shared.nodes == alone.nodes);
        CHECK(isSame(shared.primary.color.value(), alone.primary.color.value()));
        CHECK(isSame(*shared.primary.color, lab::traceRay(ray, scene, 3)));
    }
}
