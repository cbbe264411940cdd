#include "lab/samplePlaces.h"

using namespace lab;
using namespace sw;

// Which depth samplePixel() hands on.

namespace {

// Two mirrors face to face, before and behind the eye: the deeper, the more rays.
Scene corridor() {
    Scene scene = skyScene();
    scene.push(std::make_shared<Pane>(Pane(-10, 1, opaque(0.5f))));
    scene.push(std::make_shared<Pane>(Pane(10, -1, opaque(0.5f))));
    return scene;
}

constexpr int manyRays = 2000;  // a recursion without end is task 4's business

// The rays of a pixel in the corridor, and those of its samples by themselves.
struct DepthCase {
    int n, depth;
    std::size_t got;
    std::vector<Ray> asked;  // by samplePixel(); several times if it did so

    std::size_t raysAt(int someDepth) const {
        std::size_t sum = 0;
        for (const Ray& ray : asked) sum += raysFor(corridor(), ray, someDepth, manyRays);
        return sum;
    }
};

DepthCase depthCase(int n, int depth) {
    seedPixel(6, n, depth);
    const Pixel open = pixelOf(skyScene(), 1, 1, n);
    seedPixel(6, n, depth);
    const Pixel pixel = pixelOf(corridor(), 1, 1, n, depth, manyRays);
    if (pixel.endless || open.endless) throw TooManyRays();
    DepthCase one{n, depth, pixel.rays.size(), {}};
    // Of all that traceRay() asked about a sample under the open sky, the first.
    std::size_t step = 1;
    if (!open.primary.empty()) step = std::max(step, raysFor(skyScene(), open.primary[0], 3));
    for (std::size_t i = 0; i < open.rays.size(); i += step) one.asked.push_back(open.rays[i]);
    return one;
}

// Each depth of 0..9 must have a number of rays of its own to be recognised by it.
std::string depthHint() {
    const DepthCase one = depthCase(2, 3);
    std::set<std::size_t> numbers;
    for (int depth = 0; depth < 10; ++depth) numbers.insert(one.raysAt(depth));
    if (numbers.size() < 10) return "";
    std::vector<DepthCase> cases;
    for (const int n : {2, 3})
        for (const int depth : {1, 2, 4, 5}) cases.push_back(depthCase(n, depth));
    const auto always = [&](auto wrongDepth) {
        return std::all_of(cases.begin(), cases.end(),
                           [&](const DepthCase& c) { return c.got == c.raysAt(wrongDepth(c)); });
    };
    for (int depth = 0; depth < 10; ++depth)
        if (always([&](const DepthCase&) { return depth; }))
            return "these are the rays of depth " + std::to_string(depth) +
                   ", whatever depth was asked for: samplePixel() hands on the depth that it was "
                   "given";
    if (always([](const DepthCase& c) { return c.n; }))
        return "these are the rays of depth n: the number of samples is not the depth";
    for (const int step : {-1, 1})
        if (always([&](const DepthCase& c) { return c.depth + step; }))
            return std::string("these are the rays of a depth one ") +
                   (step < 0 ? "less" : "more") +
                   " than asked for: a step of depth is a reflection or refraction, not a sample";
    return "";
}

std::string depthHintIfAny() {
    try {
        return depthHint();
    } catch (const TooManyRays&) {
        return "";
    }
}

}  // namespace

TEST_CASE("every sample is traced to the depth that was asked for", "[lab6]") {
    if (const Pixel pixel = pixelOf(skyScene(), 1, 1, 2); pixel.samples.size() < 2)
        fail({"samplePixel() with n = 2", std::to_string(pixel.samples.size()) + " sample",
              "4 samples", sampleHint()});
    for (const int depth : {0, 1, 2, 4, 5}) {
        std::size_t got = 0, expected = 0;
        try {
            const DepthCase one = depthCase(2, depth);
            got = one.got;
            expected = one.raysAt(depth);
        } catch (const TooManyRays&) {
            continue;
        }
        if (got == expected) continue;
        fail(
            {"samplePixel() with n = 2 and depth " + std::to_string(depth) + " between two mirrors",
             std::to_string(got) + " rays", std::to_string(expected) + " rays", depthHintIfAny()});
    }
}
