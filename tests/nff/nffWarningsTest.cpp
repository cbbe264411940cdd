#include "files.h"
#include "nff/nff.h"
#include "testScenes.h"

using namespace sw;
using namespace test;

namespace {

const std::string bowtie = "p 4  0 0 0  4 4 0  4 0 0  0 4 0\n";
const std::string dent = "pp 4  0 0 0 0 0 1  4 0 0 0 0 1  4 4 1 0 0 1  0 4 0 0 0 1\n";
const std::string lid = "c 0 0 9 2  0 0 9 1\n";

// The reader's words.
std::string polygonWarning(const std::string& place, const std::string& what, int count) {
    return "a.nff:" + place + ": warning: polygon " + what +
           " (rendered as well as possible; polygons not planar or crossing themselves in this "
           "file: " +
           std::to_string(count) + ")";
}
std::string coneWarning(const std::string& place, int count) {
    return "a.nff:" + place +
           ": warning: cone has no height (left out; cones without height in this file: " +
           std::to_string(count) + ")";
}

}  // namespace

TEST_CASE("shipped scenes give no warning") {
    for (const auto& entry : fs::directory_iterator(SW_SCENES))
        if (entry.path().extension() == ".nff") CHECK(loadNff(entry.path()).warnings.empty());
}

TEST_CASE("polygons that cross themselves or are not planar give one warning at the first") {
    CHECK(warningsOf("\n  " + bowtie) == std::vector{polygonWarning("4:3", "crosses itself", 1)});
    CHECK(warningsOf("b 0 0 0\n" + dent) == std::vector{polygonWarning("4:1", "is not planar", 1)});
    CHECK(warningsOf(dent + bowtie + "s 0 0 0 1\n" + bowtie) ==
          std::vector{polygonWarning("3:1", "is not planar", 3)});
}

TEST_CASE("cones without height give one warning at the first and are left out") {
    CHECK(warningsOf(" " + lid + "s 0 0 0 1") == std::vector{coneWarning("3:2", 1)});
    CHECK(warningsOf(lid + "c 0 0 0 1 0 0 1 1\n" + lid + lid) ==
          std::vector{coneWarning("3:1", 3)});
    CHECK(countOf(parse(grey + lid + "c 0 0 0 1 0 0 1 1\n").scene, "cones") == 1);
}

TEST_CASE("each kind of oddity has its warning") {
    CHECK(warningsOf(lid + bowtie) ==
          std::vector{coneWarning("3:1", 1), polygonWarning("4:1", "crosses itself", 1)});
}

TEST_CASE("the number of warnings does not grow with the file") {
    std::string many;
    for (int i = 0; i < 20000; ++i) many += bowtie + dent + lid;
    CHECK(warningsOf(many) ==
          std::vector{polygonWarning("3:1", "crosses itself", 40000), coneWarning("5:1", 20000)});
}

TEST_CASE("odd polygons are rendered as well as possible") {
    const Scene scene = parse(grey + bowtie + "f 0 1 0 1 0 0 0 1\n" + dent).scene;
    Intersection hit;
    CHECK(scene.intersect(Ray(Vec3(2, 1, 9), Vec3(0, 0, -1)), hit));
    for (const float x : {1.0f, 2.0f, 3.0f})
        for (const float y : {1.1f, 2.1f, 3.1f}) {
            CAPTURE(x, y);
            CHECK(scene.intersect(Ray(Vec3(x, y, 9), Vec3(0, 0, -1)), hit));
        }
}

TEST_CASE("polygons are not called odd for rounding or for repeated vertices") {
    Random random(GENERATE(range(0u, 100u)));
    // A parallelogram far from the origin, in six digits as %g writes it.
    const Vec3 at = random.point(100), a = random.point(1), b = random.point(1);
    std::ostringstream square;
    for (const Vec3& v : {at, at, at + a, at + a + b, at + b})
        square << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
    if ((a % b).norm() < 0.1f) return;
    CAPTURE(square.str());
    CHECK(warningsOf("s 0 0 0 1\np 5\n" + square.str()).empty());
}
