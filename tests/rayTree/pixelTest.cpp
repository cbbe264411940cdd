#include <array>

#include "nff/shippedScenes.h"
#include "rayTree/pixelStudents.h"
#include "swRayCount.h"
#include "tools/common/mainFunctions.h"

// The tree of rays behind a pixel is what lab::traceRay() did, and its numbers explain the colour.

using namespace test;
using rayTree::growTree;
using rayTree::RayNode;
using rayTree::RayTree;
using sw::RayKind;

namespace {

// Whether the rays are those that the function casts without being watched.
bool isWhatHappens(const rayTree::Trace& trace, const Ray& ray, const Scene& scene, int depth) {
    sw::takeRayCount();
    const Color color = trace(ray, scene, depth);
    const sw::RayCount count = sw::takeRayCount();
    const RayTree tree = growTree(trace, ray, scene, depth);
    std::array<std::uint64_t, 5> rays{};
    visitAll(tree.primary, [&](const RayNode& node, const RayNode*) {
        ++rays[static_cast<std::size_t>(node.query.ray.kind)];
    });
    return tree.ends && tree.isFaithful && tree.nodes == count.total() && rays == count.rays &&
           tree.primary.color && isSame(*tree.primary.color, color);
}

// How far the parts of a colour are off the whole, at worst in the tree.
double unexplained(const RayTree& tree) {
    double worst = 0;
    visitAll(tree.primary, [&](const RayNode& node, const RayNode*) {
        if (!node.isTraced || !node.query.isHit) return;
        dvec3 sum = toDouble(node.otherAdds);
        for (const Color& light : node.lightAdds) sum += toDouble(light);
        for (const RayNode& child : node.children)
            if (child.isTraced) sum += toDouble(child.weight) * toDouble(*child.color);
        worst = std::max(worst, distance(*node.color, sum));
    });
    return worst;
}

// Rays whose weight is not exactly what the material says.
int wrongWeights(const RayTree& tree) {
    int wrong = 0;
    visitAll(tree.primary, [&](const RayNode& node, const RayNode* parent) {
        if (!parent || !node.isTraced) return;
        const Material& material = parent->query.hit.material;
        const bool mirrored = node.query.ray.kind == RayKind::reflected;
        const float w = mirrored ? material.reflectivity : material.transparency;
        wrong += !isSame(node.weight, Color(w, w, w));
    });
    return wrong;
}

// Rays that do not start where their parent hit, or whose depth is not one less.
int wrongParents(const RayTree& tree) {
    int wrong = 0;
    visitAll(tree.primary, [&](const RayNode& node, const RayNode* parent) {
        if (!parent) return;
        wrong += distance(node.query.ray.orig, parent->query.hit.position) > 1e-3;
        wrong += node.isTraced && node.depth != parent->depth - 1;
        wrong += node.isTraced == (node.query.ray.kind == RayKind::shadow);
    });
    return wrong;
}

Student anyStudent() {
    Student student;
    student.ownRays = GENERATE(false, true);
    student.copiesScene = GENERATE(false, true);
    return student;
}

}  // namespace

TEST_CASE("the tree holds just the rays of the picture in every shipped scene") {
    for (const fs::path& path : shippedScenes()) {
        sw::NffScene file = sw::loadNff(path);
        file.camera.setup(12, 12);
        int wrong = 0;
        for (int i = 0; i < 144; ++i) {
            const Ray ray = file.camera.getRay(static_cast<float>(i % 12) + 0.5f,
                                               static_cast<float>(i / 12) + 0.5f);
            for (const int depth : {0, 1, 3})
                wrong += !isWhatHappens(lab::traceRay, ray, file.scene, depth);
        }
        CAPTURE(path);
        CHECK(wrong == 0);
    }
}

TEST_CASE("the tree explains colours and weights of random scenes") {
    Random random(GENERATE(range(0u, 60u)));
    const Scene scene = randomRoom(random);
    const Ray ray = randomLook(random);
    const int depth = random.whole(0, 5);
    CHECK(isWhatHappens(lab::traceRay, ray, scene, depth));
    const RayTree tree = growTree(lab::traceRay, ray, scene, depth);
    CHECK(unexplained(tree) < 1e-5);
    CHECK(wrongWeights(tree) == 0);
    CHECK(wrongParents(tree) == 0);
}

TEST_CASE("rays that students make themselves are told apart by their effect") {
    const Student student = anyStudent();
    Random random(GENERATE(range(0u, 25u)));
    const Scene scene = randomRoom(random);
    const Ray ray = randomLook(random);
    const int depth = random.whole(0, 4);
    CHECK(isWhatHappens(student, ray, scene, depth));
    const RayTree tree = growTree(student, ray, scene, depth);
    CHECK(unexplained(tree) < 1e-5);
    int wrong = 0;
    visitAll(tree.primary, [&](const RayNode& node, const RayNode*) {
        const bool toLight = node.query.ray.maxT <= 1;  // as this student ends shadow rays
        wrong += node.isTraced == toLight || (node.light >= 0) != toLight;
    });
    CHECK(wrong == 0);
}

TEST_CASE("rays of weight 0 are followed like all others") {
    Student student;
    student.testsWeight = false;
    student.ownRays = GENERATE(false, true);
    Random random(GENERATE(range(0u, 25u)));
    const Scene scene = randomRoom(random);
    const Ray ray = randomLook(random);
    CHECK(isWhatHappens(student, ray, scene, 2));
    CHECK(unexplained(growTree(student, ray, scene, 2)) < 1e-5);
}

TEST_CASE("a ray that goes to a light by chance is not taken for a shadow ray") {
    Student student;
    student.ownRays = true;
    student.testsWeight = false;
    const float r = GENERATE(0.f, 0.5f);
    const bool blocked = GENERATE(false, true);
    if (r == 0 && !blocked) return;  // then they cannot be told apart
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 3, Material(Color(1, 1, 1), r)));
    if (blocked) scene.push(Sphere(Vec3(0, 0, 30), 1, Material(Color(1, 1, 1))));
    scene.push(Light(Vec3(0, 0, 40)));
    scene.setBackground(Color(1, 1, 1));
    const Ray ray(Vec3(0, 0, 9), Vec3(0, 0, -1));  // it comes back the same way
    CAPTURE(r, blocked);
    CHECK(isWhatHappens(student, ray, scene, 1));
    const RayTree tree = growTree(student, ray, scene, 1);
    REQUIRE(tree.primary.children.size() == 3);
    CHECK_FALSE(tree.primary.children[0].isTraced);
    CHECK(tree.primary.children[0].light == 0);
    CHECK(tree.primary.children[1].isTraced);
    CHECK(tree.primary.children[1].light == -1);
    CHECK(isSame(tree.primary.children[1].weight, Color(r, r, r)));
}

TEST_CASE("the weight is what the function multiplies with whatever the material says") {
    Student student;
    student.indexAsWeight = true;
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 3, Material(Color(1, 1, 1), 0.2f, 0.8f, 1.3f)));
    scene.setBackground(Color(1, 1, 1));
    const RayTree tree = growTree(student, Ray(Vec3(1, 1, 9), Vec3(0, 0, -1)), scene, 1);
    REQUIRE(tree.primary.children.size() == 2);
    CHECK(tree.primary.children[0].weight[0] == 0.2f);
    CHECK(tree.primary.children[1].weight[2] == 1.3f);
}

TEST_CASE("a black return in shadow takes away the rays that would follow") {
    Student student;
    student.blackInShadow = true;
    student.ownRays = GENERATE(false, true);
    Random random(GENERATE(range(0u, 40u)));
    const Scene scene = randomRoom(random);
    CHECK(isWhatHappens(student, randomLook(random), scene, 3));
}

TEST_CASE("two equal rays have a weight each") {
    const rayTree::Trace twice = [](const Ray& ray, const Scene& scene, int depth) -> Color {
        Intersection hit;
        if (!scene.intersect(ray, hit)) return scene.background();
        if (depth == 0) return Color(0, 0, 0);
        const Ray next = hit.getReflectedRay();
        Intersection ignored;
        Color color = 0.25f * (scene.intersect(next, ignored) ? Color() : scene.background());
        return color + 0.5f * (scene.intersect(next, ignored) ? Color() : scene.background());
    };
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 3, Material()));
    scene.setBackground(Color(1, 2, 3));
    const RayTree tree = growTree(twice, Ray(Vec3(1, 1, 9), Vec3(0, 0, -1)), scene, 1);
    REQUIRE(tree.primary.children.size() == 2);
    CHECK(isSame(tree.primary.children[0].weight, Color(0.25f, 0.25f, 0.25f)));
    CHECK(isSame(tree.primary.children[1].weight, Color(0.5f, 0.5f, 0.5f)));
}

TEST_CASE("light without a shadow ray and light from nowhere are reported") {
    Student student;
    student.testsShadow = false;
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 3, Material(Color(1, 0.5f, 0))));
    scene.push(Light(Vec3(0, 0, 9)));
    scene.push(Light(Vec3(0, 9, 9), Color(0.5f, 0, 0)));
    const Ray ray(Vec3(0, 0, 8), Vec3(0, 0, -1));
    const rayTree::Trace ambient = [&](const Ray& r, const Scene& s, int depth) {
        return student(r, s, depth) + Color(0, 0, 0.125f);
    };
    const RayTree tree = growTree(ambient, ray, scene, 3);
    CHECK(tree.primary.children.empty());
    REQUIRE(tree.primary.lightAdds.size() == 2);
    CHECK(distance(tree.primary.lightAdds[0], Vec3(1, 0.5f, 0)) < 1e-6);
    CHECK(distance(tree.primary.lightAdds[1], dvec3(0.5 * 6 / std::sqrt(117.0), 0, 0)) < 1e-6);
    CHECK(isSame(tree.primary.otherAdds, Color(0, 0, 0.125f)));
}

TEST_CASE("rays keep their limits") {
    struct Limited {
        Color operator()(const Ray& ray, const Scene& scene, int depth) const {
            Intersection hit;
            if (!scene.intersect(ray, hit)) return scene.background();
            return depth == 0 ? Color() : (*this)(Ray(hit.position, ray.dir, from, to), scene, 0);
        }
        float from, to;
    };
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 3, Material()));  // 6 from front to back
    const auto hits = [&](float from, float to) {
        const RayTree tree =
            growTree(Limited{from, to}, Ray(Vec3(0, 0, 9), Vec3(0, 0, -1)), scene, 1);
        REQUIRE(tree.primary.children.size() == 1);
        return tree.primary.children[0].query.isHit;
    };
    CHECK((hits(1, 7) && !hits(1, 5) && !hits(7, 9) && !hits(0, 0)));
}

TEST_CASE("a function that always returns white has no rays") {
    const auto white = [](const Ray&, const Scene&, int) { return Color(1, 1, 1); };
    const RayTree tree = growTree(white, Ray(Vec3(0, 0, 8), Vec3(0, 0, -1)), Scene(), 3);
    CHECK((tree.ends && tree.isFaithful && !tree.primary.asked));
    CHECK((tree.cast == 0 && tree.nodes == 0));
    CHECK(tree.primary.color.value().isZero() == false);
}
