#include <limits>

#include "rayTree/pixelStudents.h"
#include "testScenes.h"

// What goes wrong behind a pixel is marked where it begins.

using namespace test;
using rayTree::growTree;
using rayTree::RayNode;
using rayTree::RayTree;

namespace {

constexpr float noNumber = std::numeric_limits<float>::quiet_NaN();
constexpr float tooLarge = std::numeric_limits<float>::infinity();

// All marks in the tree, the first rays' first.
std::vector<std::string> faultsOf(const RayTree& tree) {
    std::vector<std::string> all;
    visitAll(tree.primary, [&](const RayNode& node, const RayNode*) {
        all.insert(all.end(), node.faults.begin(), node.faults.end());
    });
    return all;
}

// Adds something to the colour of every hit on a sphere of radius below 1.5.
class Spoilt {
public:
    explicit Spoilt(const Color& c) : poison(c) {}
    Color operator()(const Ray& ray, const Scene& scene, int depth) const {
        Intersection hit;
        if (!scene.intersect(ray, hit)) return scene.background();
        Color color(0.5f, 0.5f, 0.5f);
        const float r = hit.material.reflectivity, t = hit.material.transparency;
        if (depth > 0 && r > 0) color += r * (*this)(hit.getReflectedRay(), scene, depth - 1);
        if (depth > 0 && t > 0) color += t * (*this)(hit.getRefractedRay(), scene, depth - 1);
        return isPoisoned(hit) ? color + poison : color;
    }
    static bool isPoisoned(const Intersection& hit) { return hit.material.color[0] < 0.4f; }

private:
    Color poison;
};

// A primitive whose hits have a normal that is no number.
class Broken : public sw::Primitive {
public:
    explicit Broken(const Material& surface) : Primitive(surface), plane(0, surface) {}
    bool intersect(const Ray& ray, Intersection& hit) const override {
        if (!plane.intersect(ray, hit)) return false;
        hit.normal = Vec3(0, noNumber, 1);
        return true;
    }

private:
    Plane plane;
};

const Ray down(Vec3(0.5f, 0, 8), Vec3(0, 0, -1));

// A room from which no ray escapes.
Scene insideOf(const Material& mirror) {
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 10, mirror));
    return scene;
}

}  // namespace

TEST_CASE("right solutions have no faults") {
    Random random(GENERATE(range(0u, 30u)));
    const Scene scene = randomRoom(random);
    CHECK(faultsOf(growTree(Student(), randomLook(random), scene, 3)).empty());
}

TEST_CASE("bad colours are marked at the deepest rays that bring them and nowhere else") {
    const auto [poison, name] = GENERATE(
        table<float, std::string>({{noNumber, "NaN first appears here, in the colour"},
                                   {tooLarge, "infinity first appears here, in the colour"},
                                   {-1e4f, "a negative colour first appears here"}}));
    const Spoilt trace(Color(0, poison, 0));
    const std::vector<std::string> none, one{name};
    int marked = 0, wrong = 0, shared = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Random random(seed);
        const Scene scene = randomRoom(random);
        const RayTree tree = growTree(trace, randomLook(random), scene, 4);
        // A fault begins at a poisoned hit unless there is another below it.
        const std::function<bool(const RayNode&)> check = [&](const RayNode& node) {
            bool below = false;
            for (const RayNode& child : node.children) below |= check(child);
            const bool here = node.query.isHit && Spoilt::isPoisoned(node.query.hit);
            const bool first = here && !below;
            wrong += node.faults != (first ? one : none);
            marked += first;
            shared += below;
            return here || below;
        };
        check(tree.primary);
    }
    CHECK(wrong == 0);
    CHECK(marked > 10);
    CHECK(shared > 10);
}

TEST_CASE("a hit record with NaN is reported at the hit alone") {
    Scene scene;
    scene.push(std::make_shared<Broken>(Material(Color(1, 1, 1), 0.5f)));
    scene.push(Light(Vec3(0, 0, 5)));
    // Only its mirror image is seen.
    scene.push(Sphere(Vec3(0.5f, 0, 10), 1, Material(Color(1, 1, 1), 0.5f)));
    Student student;
    student.clampsCosine = false;  // max(0, NaN) may be 0
    const RayTree tree = growTree(student, Ray(Vec3(0.5f, 0, 2), Vec3(0, 0, 1)), scene, 3);
    CHECK(std::isnan(tree.primary.color.value()[0]));
    CHECK(faultsOf(tree) ==
          std::vector<std::string>{"NaN first appears here, in the hit's normal"});
    REQUIRE(tree.primary.children.size() == 2);
    CHECK(tree.primary.faults.empty());
    CHECK(tree.primary.children[1].faults.size() == 1);
}

TEST_CASE("a ray with NaN is marked itself") {
    // sqrt of a negative number where light cannot leave glass
    const rayTree::Trace trace = [](const Ray& ray, const Scene& s, int depth) -> Color {
        Intersection hit;
        if (!s.intersect(ray, hit)) return s.background();
        const Vec3 direction(0, std::sqrt(-std::fabs(hit.normal[2])), 1);
        s.intersect(Ray(hit.position, direction), hit);
        return Color(static_cast<float>(depth), 0, 0);
    };
    const RayTree tree = growTree(trace, down, insideOf(Material()), 3);
    CHECK(faultsOf(tree) ==
          std::vector<std::string>{"NaN first appears here, in the ray's direction"});
    CHECK(tree.primary.faults.empty());
}

TEST_CASE("a cosine that is not cut off at 0 gives a negative colour") {
    Student student;
    student.clampsCosine = false;
    student.testsShadow = false;
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 3, Material(Color(1, 1, 1))));
    scene.push(Light(Vec3(0, 0, -9)));
    CHECK(faultsOf(growTree(student, down, scene, 3)) ==
          std::vector<std::string>{"a negative colour first appears here"});
}

TEST_CASE("a recursion that does not end is stopped and its first rays are shown") {
    Student student;
    student.ownRays = GENERATE(false, true);
    student.copiesScene = GENERATE(false, true);
    (GENERATE(false, true) ? student.decreasesDepth : student.testsDepth) = false;
    const float t = GENERATE(0.f, 0.3f);
    const RayTree tree =
        growTree(student, down, insideOf(Material(Color(1, 1, 1), 0.5f, t, 1.5f)), 3);
    CHECK_FALSE(tree.ends);
    CHECK(tree.cast == rayTree::mostRays);
    CHECK((tree.nodes > 10 && tree.nodes < 100));
    CHECK(tree.isFaithful);
    CHECK_FALSE(tree.primary.color);
    const std::vector<std::string> faults = faultsOf(tree);
    REQUIRE(faults.size() == 1);
    if (!student.decreasesDepth)
        CHECK(faults[0] == "the depth did not decrease: it is still 3");
    else
        CHECK(faults[0] == "the depth was used up already, and yet this ray was cast");
}

TEST_CASE("a depth that takes too many rays is not a fault") {
    const float t = GENERATE(0.f, 0.3f);
    const Scene scene = insideOf(Material(Color(1, 1, 1), 0.5f, t, 1.5f));
    const RayTree tree = growTree(Student(), down, scene, 5000);
    CHECK_FALSE(tree.ends);
    CHECK(tree.nodes > 10);
    CHECK(tree.isFaithful);
    CHECK(faultsOf(tree).empty());
}

TEST_CASE("one reflection too many is marked at that ray") {
    const rayTree::Trace oneMore = [](const Ray& ray, const Scene& scene, int depth) {
        struct Tracer {
            Color operator()(const Ray& r, const Scene& s, int d) const {
                Intersection hit;
                if (!s.intersect(r, hit)) return s.background();
                if (d < 0) return Color(1, 1, 1);
                return 0.5f * (*this)(hit.getReflectedRay(), s, d - 1);
            }
        };
        return Tracer()(ray, scene, depth);
    };
    const int depth = GENERATE(0, 1, 4);
    const RayTree tree = growTree(oneMore, down, insideOf(Material(Color(1, 1, 1), 0.5f)), depth);
    CHECK(tree.ends);
    CHECK(tree.nodes == static_cast<unsigned>(depth) + 2);
    const RayNode* last = &tree.primary;
    while (!last->children.empty()) last = &last->children[0];
    CHECK(last->depth == -1);
    CHECK(last->faults.size() == 1);
    CHECK(faultsOf(tree).size() == 1);
}

TEST_CASE("a function that behaves differently each time is detected") {
    const bool otherNumber = GENERATE(false, true);
    int calls = 0;
    const rayTree::Trace fickle = [&](const Ray& ray, const Scene& scene, int) {
        Intersection hit;
        scene.intersect(ray, hit);
        const float start = otherNumber ? 1.f : 0.01f * static_cast<float>(calls);
        if (calls++ == 0 || !otherNumber) scene.intersect(Ray(ray.orig, ray.dir, start), hit);
        return Color(0, 0, 0);
    };
    CHECK_FALSE(growTree(fickle, down, insideOf(Material()), 3).isFaithful);
}
