#include "rayTree/darkness.h"

#include "files.h"
#include "rayTree/pixelStudents.h"
#include "tools/common/mainFunctions.h"

// Why a point of the picture is dark.

using namespace test;
using rayTree::growTree;
using rayTree::RayNode;

namespace {

const Ray ray(Vec3(0, 0, 9), Vec3(0, 0, -1), 0, FLT_MAX, sw::RayKind::primary);

std::vector<std::string> reasons(const Scene& scene, int depth) {
    const rayTree::RayTree tree = growTree(lab::traceRay, ray, scene, depth);
    return darkReasons(tree.primary, scene.lights());
}

Scene ball(const Material& material) {
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 1, material));
    return scene;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("a ball without a light says so, and a lit one gives no reason") {
    Scene scene = ball(Material(Color(1, 1, 1)));
    CHECK(reasons(scene, 1) == Lines{"no light in the scene, so nothing is scattered"});
    scene.push(Light(Vec3(0, 0, 5)));
    CHECK(reasons(scene, 1).empty());
}

TEST_CASE("each light that cannot reach a surface has its reason") {
    Scene scene = ball(Material(Color(1, 1, 1)));
    scene.push(Light(Vec3(0, 0, 5)));
    scene.push(Light(Vec3(0, 0, 0)));
    scene.push(Light(Vec3(0, -9, 0.5f)));
    scene.push(Light(Vec3(0, 0, 8), Color(0, 0, 0)));
    CHECK(reasons(scene, 1) == Lines{"light 2 at (0, 0, 0) is behind the surface",
                                     "light 3 at (0, -9, 0.5) is behind the surface",
                                     "light 4 at (0, 0, 8) is black"});
}

TEST_CASE("a shadow is no reason, as it has a ray of its own") {
    Scene scene = ball(Material(Color(1, 1, 1)));
    scene.push(Sphere(Vec3(0, 0, 20), 5, Material(Color(1, 1, 1))));
    scene.push(Light(Vec3(0, 0, 40)));
    const rayTree::RayTree tree = growTree(lab::traceRay, ray, scene, 1);
    CHECK(darkReasons(tree.primary, scene.lights()).empty());
    REQUIRE(tree.primary.children.size() == 1);
    CHECK(tree.primary.children[0].query.isHit);
}

TEST_CASE("a black material says so, whatever lights there are") {
    Scene scene = ball(Material(Color(0, 0, 0)));
    const Lines black{
        "the material scatters nothing: its colour (in the scene file: times Kd) is black"};
    CHECK(reasons(scene, 1) == black);
    scene.push(Light(Vec3(0, 0, 5)));
    CHECK(reasons(scene, 1) == black);
}

TEST_CASE("a used-up depth is a reason just where a ray of some weight would follow") {
    const float weight = GENERATE(0.f, 0.25f, 1.f);
    const bool mirrors = GENERATE(true, false);
    const int depth = GENERATE(0, 1, 2);
    CAPTURE(weight, mirrors, depth);
    Scene scene = ball(Material(Color(1, 1, 1), mirrors ? weight : 0, mirrors ? 0 : weight, 1.5f));
    scene.push(Light(Vec3(0, 0, 5)));
    const Lines found = reasons(scene, depth);
    CHECK(found.size() == (depth == 0 && weight > 0 ? 1 : 0));
    if (!found.empty())
        CHECK(found[0] == std::string("the depth is used up: no ") +
                              (mirrors ? "reflected" : "refracted") + " ray of weight " +
                              (weight == 1 ? "1" : "0.25") + " follows");
}

TEST_CASE("in random rooms all light that is missing has a reason or a ray, and no other has") {
    const auto seed = GENERATE(range(0u, 100u));
    CAPTURE(seed);
    Random random(seed);
    const Scene scene = randomRoom(random);
    const rayTree::RayTree tree = growTree(lab::traceRay, randomLook(random), scene, 3);
    visitAll(tree.primary, [&](const RayNode& node, const RayNode*) {
        if (!node.isTraced || !node.query.isHit || scene.lights().empty()) return;
        std::string all;
        for (const std::string& line : darkReasons(node, scene.lights())) all += line + "\n";
        for (std::size_t i = 0; i < scene.lights().size(); ++i) {
            const bool asked = std::any_of(
                node.children.begin(), node.children.end(),
                [&](const RayNode& child) { return child.light == static_cast<int>(i); });
            CHECK(has(all, "light " + std::to_string(i + 1) + " at") == !asked);
        }
        CHECK(has(all, "depth is used up") ==
              (node.depth == 0 &&
               node.query.hit.material.reflectivity + node.query.hit.material.transparency > 0));
    });
}
