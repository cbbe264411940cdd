#include "files.h"
#include "rayTree/pixelStudents.h"
#include "rayTree/rayTreeText.h"
#include "testScenes.h"

// What is said about the rays behind a pixel.

using namespace test;
using rayTree::growTree;

namespace {

std::string told(const rayTree::Trace& trace, const Ray& ray, const Scene& scene, int depth,
                 const std::vector<sw::NffShape>& shapes = {}) {
    return describe(growTree(trace, ray, scene, depth), scene, rayTree::ShapeNames(shapes));
}

// A ball of glass before a white sky, and a ray at it.
Scene ball(const Material& material = Material(Color(1, 1, 1), 0.2f, 0.75f, 1.3f)) {
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 3, material));
    scene.setBackground(Color(1, 1, 1));
    return scene;
}
const Ray ray(Vec3(1, 0, 9), Vec3(0, 0, -1), 0, FLT_MAX, sw::RayKind::primary);

}  // namespace

TEST_CASE("a weight that is the material's stands alone") {
    for (const bool ownRays : {false, true}) {
        Student student;
        student.ownRays = ownRays;
        const std::string text = told(student, ray, ball(), 3);
        CAPTURE(text);
        CHECK((has(text, "weight 0.2, depth 2: ") && has(text, "weight 0.75, depth 2: ")));
        CHECK_FALSE(has(text, "material says"));
        CHECK_FALSE(has(text, "!!"));
    }
}

TEST_CASE("a weight that differs from the material's is shown with it") {
    Student student;
    student.indexAsWeight = true;
    CHECK(has(told(student, ray, ball(), 1),
              "refracted ray, weight 1.3 (the material says transparency 0.75), depth 0: "));
    student.ownRays = true;
    CHECK(has(told(student, ray, ball(), 1),
              "other ray, weight 1.3 (the material says reflectivity 0.2, transparency 0.75)"));
    const rayTree::Trace tinted = [](const Ray& r, const Scene& scene, int) -> Color {
        Intersection hit;
        if (!scene.intersect(r, hit)) return scene.background();
        const bool away = !scene.intersect(hit.getReflectedRay(), hit);
        return away ? Color(0.5f, 1, 1).times(scene.background()) : Color();
    };
    CHECK(has(told(tinted, ray, ball(), 1),
              "reflected ray, weight (0.5, 1, 1) (the material says reflectivity 0.2)"));
}

TEST_CASE("total internal reflection is named and may be a reflected ray") {
    const Material glass(Color(1, 1, 1), 0.2f, 0.75f, 1.5f);
    const Ray steep(Vec3(2.5f, 0, 0), Vec3(0, 0, -1));  // inside
    CHECK_FALSE(has(told(Student(), ray, ball(glass), 1), "total"));
    CHECK(has(told(Student(), steep, ball(glass), 1),
              "refracted ray (total internal reflection), weight 0.75, depth 0: "));
    const rayTree::Trace twice = [](const Ray& r, const Scene& s, int depth) -> Color {
        struct Tracer {
            Color operator()(const Ray& in, const Scene& scene, int d) const {
                Intersection hit;
                if (!scene.intersect(in, hit)) return scene.background();
                if (d == 0) return Color(1, 1, 1);
                const Ray next = hit.getReflectedRay();
                return 0.2f * (*this)(next, scene, d - 1) + 0.75f * (*this)(next, scene, d - 1);
            }
        };
        return Tracer()(r, s, depth);
    };
    const std::string text = told(twice, steep, ball(glass), 1);
    CAPTURE(text);
    CHECK(has(text, "reflected ray, weight 0.2, depth 0: "));
    CHECK(has(text, "weight 0.75 (the transparency: total internal reflection?), depth 0: "));
}

TEST_CASE("faults are printed below their ray") {
    const rayTree::Trace poison = [](const Ray& r, const Scene& scene, int depth) {
        return Student()(r, scene, depth) + Color(0, 0, std::sqrt(r.orig[2] - 100));
    };
    const std::string text = told(poison, ray, ball(), 0);
    CAPTURE(text);
    CHECK(has(text, ": colour (0, 0, nan)\n"));
    CHECK(has(text, "\n   !! NaN first appears here, in the colour\n"));
}

TEST_CASE("a function that does not end is reported") {
    Student student;
    student.decreasesDepth = false;
    Scene scene;
    scene.push(Sphere(Vec3(0, 0, 0), 20, Material(Color(1, 1, 1), 0.5f)));
    const std::string text = told(student, ray, scene, 3);
    CAPTURE(text);
    CHECK(startsWith(text, "primary ray, depth 3: does not come back\n"));
    CHECK(has(text, "!! the depth did not decrease: it is still 3\n"));
    CHECK(has(text, "+- ...\n!! stopped after 2000 rays, "));
    CHECK(std::count(text.begin(), text.end(), '\n') < 120);
}

TEST_CASE("a shape that reports a hit at NaN is named though no ray hits it") {
    const float t = GENERATE(NAN, 3.f);
    Scene scene = ball();
    const auto claim = std::make_shared<Claim>(t);
    scene.push(claim);
    const std::string text = told(Student(), ray, scene, 0, {{claim, 7}});
    CAPTURE(text);
    CHECK(has(text, "!! other (line 7, ") == std::isnan(t));
    CHECK(has(text, "hits other (line 7, ") != std::isnan(t));
    CHECK(has(text, "hits something that is not in the scene file") == std::isnan(t));
}

TEST_CASE("light without a shadow ray and colour from nowhere have lines of their own") {
    Student student;
    student.testsShadow = false;
    Scene scene = ball(Material(Color(1, 1, 1)));
    scene.push(Light(Vec3(0, 0, -9)));
    scene.push(Light(ray.orig, Color(0.5f, 0, 0)));
    const rayTree::Trace ambient = [&](const Ray& r, const Scene& s, int depth) {
        return student(r, s, depth) + Color(0.25f, 0.25f, 0.25f);
    };
    const std::string text = told(ambient, ray, scene, 1);
    CAPTURE(text);
    CHECK_FALSE(has(text, "light 1 at (0, 0, -9) adds"));
    CHECK(has(text, "   light 1 at (0, 0, -9) is behind the surface\n"));
    CHECK(has(text, "   light 2 at (1, 0, 9) adds (0.4"));
    CHECK(has(text, ") without a shadow ray\n"));
    CHECK(has(text, "   adds (0.25, 0.25, 0.25) without light or ray\n"));
}
