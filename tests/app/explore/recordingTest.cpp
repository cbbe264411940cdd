// What --explore records is what growTree() says of every pixel.
#include "app/explore/recording.h"

#include <map>

#include "app/explore/shapeFinder.h"
#include "nff/shippedScenes.h"
#include "rayTree/pixelStudents.h"
#include "rayTree/shapeNames.h"
#include "tools/common/mainFunctions.h"

using namespace test;
using rayTree::growTree;

namespace {

Options optionsFor(int width, int height) {
    Options options;
    options.scene = fs::path(SW_SCENES) / "cornell.nff";
    options.width = width;
    options.height = height;
    options.crop = sw::Window{0, 0, width, height};
    options.threads = 2;
    return options;
}

struct LoadedScene {
    explicit LoadedScene(const fs::path& path, int width, int height)
        : file(sw::loadNff(path, &shapes)) {
        file.camera.setup(width, height);
    }
    std::vector<sw::NffShape> shapes;
    sw::NffScene file;
};

std::size_t bytesOf(const RayColumns& rays) {
    std::size_t bytes = 0;
    for (const Column& column : rays.columns)
        bytes += column.values.size() * static_cast<std::size_t>(column.bytes);
    return bytes;
}

bool isSameColumns(const RayColumns& a, const RayColumns& b) {
    for (std::size_t i = 0; i < a.columns.size(); ++i)
        if (a.columns[i].values != b.columns[i].values) return false;
    return a.rays == b.rays && a.faults.size() == b.faults.size();
}

const auto noShape = [](const Ray&, const Intersection&) { return 0u; };

}  // namespace

TEST_CASE("no ray takes more than 24 bytes") {
    Random random(GENERATE(range(0u, 40u)));
    const Scene scene = randomRoom(random);
    RayColumns rays;
    rays.add(growTree(lab::traceRay, randomLook(random), scene, 4), scene.lights(), noShape);
    const std::size_t before = bytesOf(rays);
    CHECK(before <= 24 * rays.rays);
    CHECK(rays.origins.size() <= rays.rays / 2);  // 16 bytes more, for rays that start elsewhere
}

TEST_CASE("pixels that are added apart give the same columns") {
    Random random(GENERATE(range(0u, 20u)));
    const Scene scene = randomRoom(random);
    RayColumns all, parts;
    for (int i = 0; i < 5; ++i) {
        const auto tree = growTree(Student(), randomLook(random), scene, 3);
        all.add(tree, scene.lights(), noShape);
        RayColumns part;
        part.add(tree, scene.lights(), noShape);
        parts.append(part);
    }
    CHECK(all.pixels == 5);
    CHECK(isSameColumns(all, parts));
}

TEST_CASE("the record holds every ray of every pixel, whatever the number of threads") {
    const fs::path path = GENERATE(from_range(shippedScenes()));
    const LoadedScene scene(path, 24, 17);
    Options options = optionsFor(24, 17);
    const Recording recording = recordRays(options, scene.file, scene.shapes, lab::traceRay);
    CHECK(recording.step == 1);
    std::size_t rays = 0;
    for (int y = 0; y < 17; ++y)
        for (int x = 0; x < 24; ++x)
            rays += growTree(lab::traceRay,
                             scene.file.camera.getRay(static_cast<float>(x) + 0.5f,
                                                      static_cast<float>(y) + 0.5f),
                             scene.file.scene, options.depth)
                        .nodes;
    CHECK(recording.rays.rays == rays);
    CHECK(recording.rays.pixels == 24 * 17);
    CHECK(recording.rays.faults.empty());
    options.threads = 1;
    CHECK(isSameColumns(recordRays(options, scene.file, scene.shapes, lab::traceRay).rays,
                        recording.rays));
}

TEST_CASE("the shape that a ray hit is found among all of the file") {
    const fs::path path = GENERATE(from_range(shippedScenes()));
    const LoadedScene scene(path, 40, 40);
    const ShapeFinder finder(scene.shapes);
    const rayTree::ShapeNames names(scene.shapes);
    int hits = 0, wrong = 0;
    for (int i = 0; i < 1600; ++i) {
        const Ray ray = scene.file.camera.getRay(static_cast<float>(i % 40) + 0.5f,
                                                 static_cast<float>(i / 40) + 0.5f);
        Intersection hit;
        if (!scene.file.scene.intersect(ray, hit)) continue;
        const std::size_t found = finder.find(ray, hit, 0);
        REQUIRE(found < scene.shapes.size());
        const rayTree::ShapeNames alone({scene.shapes[found]});
        wrong += alone.hitBy(ray, hit) != names.hitBy(ray, hit);
        ++hits;
    }
    CHECK(hits > 100);
    CHECK(wrong == 0);
}

TEST_CASE("large pictures and endless recursions are recorded in part") {
    const LoadedScene scene(fs::path(SW_SCENES) / "cornell.nff", 4000, 3000);
    Student endless;
    endless.decreasesDepth = endless.testsDepth = false;
    const bool ends = GENERATE(true, false);
    const rayTree::Trace trace = ends ? rayTree::Trace(lab::traceRay) : rayTree::Trace(endless);
    const Options options = optionsFor(4000, 3000);
    const Recording recording = recordRays(options, scene.file, scene.shapes, trace);
    CHECK(recording.step > 2);
    CHECK(recording.rays.rays < 1.5e6);
    CHECK(recording.columns == (4000 + recording.step - 1) / recording.step);
    CHECK(recording.rays.pixels == static_cast<std::uint32_t>(recording.columns) *
                                       static_cast<std::uint32_t>(recording.rows));
    CHECK((recording.rays.endless > 0) == !ends);
    CHECK(recording.rays.faults.empty() == ends);
}

TEST_CASE("faults are recorded at their rays") {
    const rayTree::Trace nan = [](const Ray& ray, const Scene& scene, int depth) {
        return lab::traceRay(ray, scene, depth) * (depth == 2 ? NAN : 1.f);
    };
    const LoadedScene scene(fs::path(SW_SCENES) / "cornell.nff", 20, 20);
    const Recording recording = recordRays(optionsFor(20, 20), scene.file, scene.shapes, nan);
    REQUIRE(!recording.rays.faults.empty());
    for (const RayColumns::Fault& fault : recording.rays.faults) {
        CHECK(fault.text == "NaN first appears here, in the colour");
        const std::uint32_t head = recording.rays.columns[0].values[fault.ray];
        CHECK((head & 7) >= 2);  // a reflected or refracted ray
    }
}
