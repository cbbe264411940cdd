#include "app/explore/recording.h"

#include <algorithm>
#include <cmath>

#include "app/explore/shapeFinder.h"
#include "app/stackGuard.h"
#include "swRayCount.h"
#include "swRenderer.h"

namespace {

using namespace sw;
using rayTree::Trace;

// Of the whole recording. What is asked takes the time: all rays that traceRay() casts in all
// calls.
constexpr double mostRays = 1.2e6, mostAsked = 1e7;
constexpr std::size_t shapesInView = 3000;  // if there are more, some of them

class Recorder {
public:
    Recorder(const Options& theOptions, const NffScene& theFile, const ShapeFinder& theFinder,
             const Trace& function)
        : options(theOptions), file(theFile), finder(theFinder), traceRay(function) {}

    /// The smallest step that keeps the limits, judged by some pixels all over the window.
    int findStep() const {
        const Window& window = *options.crop;
        const int every = std::max(1, std::max(window.width(), window.height()) / 16);
        rayTree::Stage stage(file.scene);
        RayColumns some;
        for (int y = window.y0 + every / 2; y < window.y1; y += every)
            for (int x = window.x0 + every / 2; x < window.x1; x += every)
                record(x, y, stage, some);
        takeRayCount();  // these are no rays of the picture
        if (some.pixels == 0) return 1;
        const double pixels = static_cast<double>(window.width()) * window.height();
        const double share =
            std::max(some.rays / mostRays, static_cast<double>(stage.asked) / mostAsked);
        return static_cast<int>(std::ceil(std::sqrt(std::max(1.0, share / some.pixels * pixels))));
    }

    void recordRow(int y, int step, RayColumns& row) const {
        rayTree::Stage stage(file.scene);
        for (int x = options.crop->x0; x < options.crop->x1; x += step) record(x, y, stage, row);
    }

private:
    void record(int x, int y, rayTree::Stage& stage, RayColumns& rays) const {
        stackGuard::watch(x, y);
        const Trace repeatable = [&](const Ray& ray, const Scene& scene, int depth) {
            seedPixel(options.seed, x, y);
            return traceRay(ray, scene, depth);
        };
        const Ray ray =
            file.camera.getRay(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
        std::size_t guess = 0;
        rays.add(rayTree::growTree(repeatable, ray, stage, options.depth, false),
                 file.scene.lights(), [&](const Ray& some, const Intersection& hit) {
                     const std::size_t found = finder.find(some, hit, guess);
                     if (found == ShapeFinder::notFound) return 0u;
                     guess = found;
                     return static_cast<std::uint32_t>(found + 1);
                 });
    }

    const Options& options;
    const NffScene& file;
    const ShapeFinder& finder;
    const Trace& traceRay;
};

// Leaves the shapes that were hit, with new numbers for them, and some of the others.
void thinShapes(Recording& recording) {
    std::vector<NffShape>& shapes = recording.shapes;
    std::vector<std::uint32_t> numbers(shapes.size() + 1, 0);  // new ones
    const auto eachNumber = [&](const auto& visit) {
        for (Column& column : recording.rays.columns)
            if (column.isShape())
                for (std::uint32_t& number : column.values) visit(number);
    };
    eachNumber([&](std::uint32_t number) { numbers[number] = 1; });
    numbers[0] = 0;
    std::vector<NffShape> hit, others;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const bool isListed = numbers[i + 1] != 0 && hit.size() < 65535;
        numbers[i + 1] = isListed ? static_cast<std::uint32_t>(hit.size()) + 1 : 0;
        (isListed ? hit : others).push_back(shapes[i]);
    }
    eachNumber([&](std::uint32_t& number) { number = numbers[number]; });
    const std::size_t room = std::max(shapesInView, hit.size()) - hit.size();
    const std::size_t every = room == 0 ? 0 : (others.size() + room - 1) / room;
    for (std::size_t i = 0; every > 0 && i < others.size(); i += every) hit.push_back(others[i]);
    shapes = std::move(hit);
}

}  // namespace

Recording recordRays(const Options& options, const NffScene& file, std::vector<NffShape> shapes,
                     const Trace& traceRay) {
    Recording result;
    result.shapes = std::move(shapes);
    const ShapeFinder finder(result.shapes);
    const Recorder recorder(options, file, finder, traceRay);
    result.step = recorder.findStep();
    const auto count = [&](int length) { return (length + result.step - 1) / result.step; };
    result.columns = count(options.crop->width());
    result.rows = count(options.crop->height());

    // Rows in place of pixels: every one has its own record.
    std::vector<RayColumns> rows(static_cast<std::size_t>(result.rows));
    RenderOptions how;
    how.threads = options.threads;
    how.tileSize = 4;
    const auto recordRow = [&](int, int row) {
        recorder.recordRow(options.crop->y0 + row * result.step, result.step,
                           rows[static_cast<std::size_t>(row)]);
        return Color();
    };
    sw::render({0, 0, 1, result.rows}, recordRow, how);
    for (RayColumns& row : rows) {
        result.rays.append(row);
        row = RayColumns();
    }
    thinShapes(result);
    return result;
}
