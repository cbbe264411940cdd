#include "nff/shippedScenes.h"
#include "png.h"

using namespace sw;
using namespace test;

TEST_CASE("every shipped scene loads and shows something lit") {
    CHECK(shippedScenes().size() >= 11);
    for (const fs::path& path : shippedScenes()) {
        CAPTURE(path.string());
        const NffScene file = loadNff(path);
        CHECK(file.scene.lights().size() >= 1);
        int hits = 0;
        for (int y = 0; y < file.height; y += 8)
            for (int x = 0; x < file.width; x += 8) {
                Intersection hit;
                const auto at = [](int i) { return static_cast<float>(i) + 0.5f; };
                hits += file.scene.intersect(file.camera.getRay(at(x), at(y)), hit);
            }
        CHECK(hits > file.width * file.height / 64 / 10);
    }
}

TEST_CASE("every shipped scene says what to see and what to try") {
    for (const fs::path& path : shippedScenes()) {
        const std::string text = contentOf(path);
        CAPTURE(path.string());
        CHECK(text.substr(0, 2) == "# ");
        CHECK(text.find("\n# You should see: ") != std::string::npos);
        CHECK(text.find("\n# Try: ") != std::string::npos);
    }
}

TEST_CASE("every shipped scene has a small picture, which the README shows") {
    const std::string readme = contentOf(shippedFolder / ".." / "README.md");
    for (fs::path path : shippedScenes()) {
        CAPTURE(path.string());
        const std::string name = "scenes/" + path.stem().string();
        CHECK(readme.find("(" + name + ".nff)") != std::string::npos);
        CHECK(readme.find("(" + name + ".png)") != std::string::npos);
        const std::string png = contentOf(path.replace_extension(".png"));
        CHECK(png.size() < 60000);
        const PngStructure picture(png);
        CHECK((picture.width == 200 && picture.height == 200));
    }
}

TEST_CASE("the lab scene has its camera and its light") {
    const NffScene file = loadNff(shippedFolder / "cornell.nff");
    CHECK((file.width == 512 && file.height == 512));
    const Ray center = file.camera.getRay(256, 256);
    CHECK(distance(center.orig, Vec3(0, 10, 30)) == 0);
    CHECK(distance(center.dir, Vec3(0, 0, -1)) <= u);
    const double top = std::asin(toDouble(file.camera.getRay(256, 0).dir).y);
    CHECK(std::fabs(top - 26 * std::acos(-1.0) / 180) <= 4 * u);
    CHECK(distance(file.scene.background(), Color(0, 0, 0)) == 0);
    REQUIRE(file.scene.lights().size() == 1);
    CHECK(distance(file.scene.lights()[0].position, Vec3(0, 30, -5)) == 0);
    CHECK(distance(file.scene.lights()[0].color, Color(1, 1, 1)) == 0);
}

TEST_CASE("the lab scene is a room with an open front") {
    const Scene scene = loadNff(shippedFolder / "cornell.nff").scene;
    const auto [wall, normal, color] =
        GENERATE(table<Vec3, Vec3, Color>({{{3, 0, 40}, {0, 1, 0}, {0.9f, 0.9f, 0.9f}},
                                           {{-3, 0, 40}, {0, 1, 0}, {0.9f, 0.9f, 0.9f}},
                                           {{15, 40, -45}, {0, -1, 0}, {0.9f, 0.9f, 0.9f}},
                                           {{-15, 40, 45}, {0, -1, 0}, {0.9f, 0.9f, 0.9f}},
                                           {{19, 38, -50}, {0, 0, 1}, {0.9f, 0.9f, 0.9f}},
                                           {{-19, 39, -50}, {0, 0, 1}, {0.9f, 0.9f, 0.9f}},
                                           {{-20, 20, -45}, {1, 0, 0}, {1, 0.1f, 0.1f}},
                                           {{-20, 39, 49}, {1, 0, 0}, {1, 0.1f, 0.1f}},
                                           {{20, 20, -45}, {-1, 0, 0}, {0.1f, 0.6f, 0.1f}},
                                           {{20, 39, 49}, {-1, 0, 0}, {0.1f, 0.6f, 0.1f}}}));
    CAPTURE(wall, normal);
    const Intersection hit = seen(scene, Vec3(0, 20, 0), wall);
    CHECK(distance(hit.position, wall) <= 40 * u);
    CHECK(distance(hit.normal, normal) <= u);
    CHECK(hit.frontFacing);
    checkMaterial(hit.material, color, 0, 0, 1);
    Intersection none;
    CHECK_FALSE(scene.intersect(Ray(Vec3(0, 20, 0), Vec3(0, 0, 1)), none));
}

TEST_CASE("the lab scene has its seven spheres") {
    struct Row {
        Vec3 center;
        Color color;
        float reflectivity, transparency, index;
    };
    const Color green(0.1f, 0.6f, 0.1f), blue(0, 0.2f, 0.9f), red(1, 0.1f, 0.1f);
    const Color yellow(1, 0.6f, 0.1f);
    const Row rows[] = {{{-7, 3, -20}, green, 0, 0, 1},     {{0, 3, -20}, blue, 0, 0, 1},
                        {{7, 3, -20}, red, 0, 0, 1},        {{7, 3, 0}, yellow, 0.2f, 0, 1},
                        {{9, 10, 0}, yellow, 0.2f, 0, 1},   {{-7, 3, 0}, {}, 0.2f, 0.8f, 1.3f},
                        {{-9, 10, 0}, {}, 0.2f, 0.8f, 1.3f}};
    for (const Row& row : rows) {
        CAPTURE(row.center);
        const Intersection hit = seen(loadNff(shippedFolder / "cornell.nff").scene,
                                      row.center + Vec3(0, 0, 5), row.center);
        CHECK(distance(hit.position, row.center + Vec3(0, 0, 3)) <= 20 * u);
        CHECK(distance(hit.normal, Vec3(0, 0, 1)) <= u);
        // Glass has no diffuse part, so its colour does not matter.
        const bool isGlass = row.transparency > 0;
        checkMaterial(hit.material, isGlass ? hit.material.color : row.color, row.reflectivity,
                      row.transparency, row.index);
    }
}

TEST_CASE("the sphere grid has eight spheres over a huge one") {
    const Scene scene = loadNff(shippedFolder / "spheres.nff").scene;
    const Material blue = seen(scene, Vec3(-6, -6, -20), Vec3(-6, -6, -6)).material;
    checkMaterial(blue, Color(0, 0.2f, 0.9f), 0, 0.7f, 1.01f);
    for (const float x : {-6.0f, 6.0f})
        for (const float y : {-6.0f, 6.0f})
            for (const float z : {-6.0f, 6.0f}) {
                const Vec3 center(x, y, z), outside(0, 0, z > 0 ? 5.0f : -5.0f);
                const Intersection hit = seen(scene, center + outside, center);
                CHECK(distance(hit.position, center + outside * 0.7) <= 20 * u);
            }
    const Intersection ground = seen(scene, Vec3(0, 0, 0), Vec3(0, -1, 0));
    CHECK(distance(ground.position, Vec3(0, -10, 0)) <= 20 * u);
    checkMaterial(ground.material, Color(0.6f, 0.6f, 0.6f), 0.5f, 0, 1);
}
