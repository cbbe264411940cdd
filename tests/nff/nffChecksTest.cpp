#include "nff/field.h"
#include "tools/common/mainFunctions.h"

using namespace sw;
using namespace test;

namespace {

const std::string eye = "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 8 8\n";
const std::string white = "f 1 1 1 1 0 0 0 1\n", black = "f 1 1 1 0 0 0 0 1\n";
const std::string mirror = "f 1 1 1 0 1 0 0 1\n", glass = "f 0 0 0 1 0.1 0 0.9 1.5\n";
const std::string ball = "s 0 0 0 1\n", light = "l 0 9 9\n";

const std::string noLight = "no light ('l') in the file: nothing is lit";
const std::string blackLights = "every light is black: nothing is lit";
const std::string noShape = "no shape in the file: the picture shows its background alone";
const std::string blackShapes = "every shape is black: Kd * colour, Ks and T of its material are 0";
const std::string onlySpecular =
    "no shape scatters light, and the background is black: the picture can only be black";
const std::string behind = "every shape is behind the camera: nothing is in view";

void checkWarning(const std::string& text, const std::string& place, const std::string& what) {
    CAPTURE(text);
    const std::vector<std::string> expected{"a.nff:" + place + ": warning: " + what};
    CHECK(warningsOf(text, eye) == (what.empty() ? std::vector<std::string>() : expected));
}

// What a small picture shows, traced as the program does.
bool isBlack(const std::string& text) {
    const NffScene file = parseNff(eye + text, "a.nff");
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const auto at = [](int i) { return static_cast<float>(i) / 2 + 0.25f; };
            const Ray ray = file.camera.getRay(at(x), at(y));
            if (!lab::traceRay(ray, file.scene, 3).isZero()) return false;
        }
    return true;
}

}  // namespace

TEST_CASE("a file without a light is warned of, unless it needs none") {
    checkWarning(white + ball, "3:10", noLight);
    checkWarning("b 1 1 1\n" + white + ball + "\n# the end", "4:10", noLight);
    checkWarning(mirror + ball + "b 1 1 1\n" + glass + ball, "", "");
    checkWarning("b 1 1 1\n" + glass + ball + mirror + ball, "", "");
    checkWarning("b 1 1 1\n" + glass + ball + white + ball, "6:10", noLight);
    checkWarning(white + ball + light, "", "");
}

TEST_CASE("lights that are all black are warned of at the first") {
    checkWarning(white + ball + "l 1 2 3 0 0 0\nl 3 2 1 0 0 0\n", "4:1", blackLights);
    checkWarning(white + ball + "l 1 2 3 0 0 0\n" + light, "", "");
    checkWarning("b 1 1 1\n" + glass + ball + "l 1 2 3 0 0 0\n", "", "");
}

TEST_CASE("a file without a shape is warned of") {
    checkWarning("b 0 0 1\n" + light + white, "4:18", noShape);
    checkWarning("", "1:64", noShape);
}

TEST_CASE("shapes that are all black are warned of at the first one's material") {
    const std::string dark = "f 0 0 0 1 0 0 0 1\n";
    checkWarning(light + white + black + ball + dark + ball, "4:1", blackShapes);
    checkWarning(black + ball, "2:1", blackShapes);
    for (const std::string& other : {white, mirror, glass})
        checkWarning("b 1 1 1\n" + light + black + ball + other + ball, "", "");
}

TEST_CASE("mirrors and glass alone before a black background are warned of at the first") {
    checkWarning(light + mirror + ball + glass + ball, "3:1", onlySpecular);
    checkWarning("b 0 0 0\n" + black + ball + glass + ball, "3:1", onlySpecular);
    checkWarning(light + mirror + ball + white + ball, "", "");
}

TEST_CASE("shapes that are all behind the camera are warned of at the view") {
    const std::string rear[] = {"s 0 0 9 1\n", "c -9 0 8 1 9 0 8 2\n", "p 3 0 0 6 1 0 6 1 1 7\n",
                                "pp 3 0 0 6 0 0 1 1 0 6 0 0 1 1 1 7 0 0 1\n"};
    std::string all = light + white;
    for (const std::string& shape : rear) {
        checkWarning(light + white + shape, "1:1", behind);
        checkWarning(light + white + shape + ball, "", "");
        all += shape;
    }
    checkWarning(all, "1:1", behind);
    checkWarning(light + white + "s 0 0 5 1\n", "", "");        // around the eye
    checkWarning(light + white + "s 0 0 6 1\n", "", "");        // touches its plane
    checkWarning(light + white + "s 0 0 3e38 3e38\n", "", "");  // as large as floats get
}

TEST_CASE("what is warned of as behind the camera is never seen") {
    int warned = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
        Random random(seed);
        const Vec3 from = random.point(3), at = random.point(3);
        std::string text = "v from " + test::text(from) + "at " + test::text(at) +
                           "up 0.1 1 0.2 angle 179 resolution 16 16\n" + light + white;
        for (int i = random.whole(1, 3); i > 0; --i)
            text += "s " + test::text(random.point(9)) + test::text(random.real(0.1, 3)) + "\n";
        const NffScene file = parseNff(text, "a.nff");
        int hits = 0;
        for (int y = 0; y <= 16; ++y)
            for (int x = 0; x <= 16; ++x) {
                Intersection hit;
                const auto side = [](int i) { return static_cast<float>(i); };
                hits += file.scene.intersect(file.camera.getRay(side(x), side(y)), hit);
            }
        CAPTURE(text, hits);
        if (file.warnings.empty()) continue;
        ++warned;
        CHECK((file.warnings.size() == 1 && has(file.warnings[0], behind) && hits == 0));
    }
    CHECK(warned > 50);
}

TEST_CASE("a picture before a black background is warned of just if it is black") {
    const std::string lights[] = {"", light, "l 1 2 3 0 0 0\n"};
    const std::string materials[] = {white, black, mirror, glass, "f 0 0 0 1 0 0 0 1\n"};
    for (const std::string& shining : lights)
        for (const std::string& first : materials)
            for (const std::string& second : materials) {
                const std::string text = shining + first + ball + second + "s 1 0 1 1\n";
                CAPTURE(text);
                CHECK(warningsOf(text, eye).size() == (isBlack(text) ? 1 : 0));
            }
}
