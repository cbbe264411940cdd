#include <cmath>

#include "tools/common/scenes/scenes.h"
#include "tools/generatedShapes.h"

using namespace test;

TEST_CASE("a ring is five cylinders between five spheres, and no two rings touch") {
    const Shapes object(scenes::rings(1));
    REQUIRE((object.tubes.size() == 30 && object.balls.size() == 30));
    for (std::size_t i = 0; i < 30; ++i) {
        const auto& [base, baseRadius, apex, apexRadius] = object.tubes[i];
        CHECK((baseRadius == apexRadius && baseRadius == object.balls[i].radius));
        CHECK(glm::distance(apex, object.balls[i].center) < 1e-6);
        CHECK(glm::distance(base, object.balls[i % 5 == 0 ? i + 4 : i - 1].center) < 1e-6);
        for (std::size_t j = 0; j < 30; ++j)
            CHECK((j / 5 == i / 5 || gap(object.balls[i], object.balls[j]) > 0.1));
    }
}

TEST_CASE("each branch of a tree carries two thinner and shorter ones where it ends") {
    const Shapes tree(scenes::tree(6));
    for (const Tube& parent : tree.tubes) {
        CHECK(std::fabs(parent.apexRadius - 0.67 * parent.baseRadius) < 1e-7);
        int children = 0;
        for (const Tube& child : tree.tubes) {
            if (glm::distance(child.base, parent.apex) > 1e-6) continue;
            const double shorter =
                glm::distance(child.base, child.apex) / glm::distance(parent.base, parent.apex);
            children += std::fabs(shorter - 0.65) < 1e-4 || std::fabs(shorter - 0.7) < 1e-4;
            CHECK(child.baseRadius == parent.apexRadius);
        }
        CHECK(children == (parent.baseRadius < 0.15 * std::pow(0.67, 5.5) ? 0 : 2));
    }
}
