#include <cstdlib>

#include "lab/samples.h"

using namespace lab;
using namespace sw;

// What samplePixel() makes of its samples.

namespace {

const std::string notYet =
    "samplePixel() in main.cpp takes a single sample, as the starter does: this is where task "
    "6 begins";

// Asks for a pixel; returns the rays from the eye, in order, as the camera made them: the witness
// may see them end at what they hit.
std::vector<Ray> ask(World& world, int n, int depth, Color& color) {
    color = pixelOf(world, 1, 1, n, depth);
    std::vector<Ray> primary;
    for (const Ray& ray : world.rays())
        if (ray.orig.isZero() && !isEmpty(ray)) primary.emplace_back(ray.orig, ray.dir, ray.minT);
    return primary;
}

}  // namespace

TEST_CASE("an even sky keeps its colour however many samples are taken", "[lab6]") {
    for (const int n : {2, 3, 4, 8}) {
        World world;
        Color got;
        const bool single = ask(world, n, 0, got).size() == 1;
        if (alike(got, sky, 1e-3f) && !single) continue;
        const float rows = static_cast<float>(n);
        fail({"samplePixel() with n = " + std::to_string(n) + " under a sky of colour " + text(sky),
              text(got) + (single ? " from a single sample" : ""), text(sky),
              single ? notYet
                     : hintFor(got,
                               {{rows * rows * sky,
                                 "this is the sum of all samples: a pixel "
                                 "shows their mean"},
                                {rows * sky,
                                 "divided by the samples of one row: there are n "
                                 "rows of them"},
                                {Color(0, 0, 0),
                                 "black: 1 divided by a whole number is 0, as "
                                 "whole numbers know no fractions"},
                                {1 / (rows * rows) * sky, "divided twice"},
                                {1 / rows * sky, "divided by more samples than were added up"}},
                               "a pixel shows the mean of its samples")});
    }
}

TEST_CASE("all samples of a pixel weigh the same", "[lab6]") {
    for (int i = 0; i < 50; ++i) {
        World world;
        // Covers a good part of pixel (1, 1).
        world.push(Sphere(Vec3(-10, 3, -20), 7, opaque()));
        seedPixel(8, i, i);
        Color got, mean;
        const std::vector<Ray> rays = ask(world, 3, 0, got);
        for (const Ray& ray : rays)
            mean += 1 / static_cast<float>(rays.size()) * world.colorOf(ray, 0);
        if (rays.size() > 1 && alike(got, mean)) continue;
        fail({"samplePixel() with n = 3 at the edge of a black ball; traceRay() was asked for " +
                  std::to_string(rays.size()) + " samples",
              text(got), text(mean) + ", their mean",
              rays.size() < 2 ? notYet
                              : "add up what all samples bring, and divide by their number once, "
                                "in the end"});
    }
}

namespace {

// Two mirrors face to face, before and behind the eye: the deeper, the more rays.
World corridor() {
    World world;
    world.push(Pane(-10, 1, opaque(0.5f)));
    world.push(Pane(10, -1, opaque(0.5f)));
    return world;
}

// The rays that the student's own traceRay() needs for some samples.
std::size_t countTraced(const std::vector<Ray>& rays, int depth) {
    std::size_t sum = 0;
    for (const Ray& ray : rays) {
        World world = corridor();
        world.colorOf(ray, depth);
        sum += world.rays().size();
    }
    return sum;
}

std::string depthHint(const std::vector<Ray>& rays, std::size_t got) {
    for (int depth = 0; depth < 10; ++depth) {
        if (countTraced(rays, depth) == got) {
            return "these are the rays of depth " + std::to_string(depth) +
                   ": samplePixel() hands on to traceRay() the depth that it was given";
        }
    }
    return "samplePixel() hands on to traceRay() the depth that it was given";
}

}  // namespace

TEST_CASE("every sample is traced to the depth that was asked for", "[lab6]") {
    for (const int depth : {0, 1, 2, 4, 5}) {
        World world = corridor();
        std::vector<Ray> rays;
        std::size_t expected = 0;
        Color color;
        try {
            rays = ask(world, 2, depth, color);
            if (rays.size() > 1) expected = countTraced(rays, depth);
        } catch (const TooManyRays&) {
            continue;  // a recursion without end is task 4's business
        }
        const std::size_t got = world.rays().size();
        if (got == expected) continue;
        fail(
            {"samplePixel() with n = 2 and depth " + std::to_string(depth) + " between two mirrors",
             std::to_string(got) + " rays", std::to_string(expected) + " rays",
             rays.size() < 2 ? notYet : depthHint(rays, got)});
    }
}

TEST_CASE("black balls with smooth edges: the picture", "[lab6]") {
    Scene scene;
    scene.setBackground(sky);
    for (const auto& [centre, radius] : {std::pair(Vec3(-9, 7, 0), 9.f),
                                         {Vec3(10, 10, 0), 6.f},
                                         {Vec3(6, -9, 0), 8.f},
                                         {Vec3(-13, -14, 0), 4.f},
                                         {Vec3(19, -1, 0), 1.f},
                                         {Vec3(-3, -16, 0), 0.5f}})
        scene.push(Sphere(centre, radius, opaque()));
    constexpr int size = 96;
    Camera camera(Vec3(0, 0, 70), Vec3(0, 0, 0), Vec3(0, 1, 0), 40);
    camera.setup(size, size);
    // A recorded picture has less noise than those that are compared with it.
    // NOLINTNEXTLINE: no thread changes the environment
    const int n = std::getenv("SW_LAB_RECORD_PICTURES") != nullptr ? 64 : 8;
    Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            seedPixel(6, x, y);
            image.at(x, y) =
                samplePixel(static_cast<float>(x), static_cast<float>(y), n, 0, camera, scene);
        }
    // Of the 433 pixels at edges, 1.7 on average and never more than 7 were off by more than 32
    // steps in 2000 pictures with other random numbers. As pixels do not depend on each other,
    // Chernoff's bound says that more than 24 of them happen less than once in 10 ^ 18 pictures.
    // With a single sample 255 pixels are off by more, with 2 x 2 at least 92.
    expectPicture("lab6-edges", image, 32, 24,
                  {"six black balls under the sky with 8 x 8 samples per pixel",
                   "the pixels at the edges show some of the sky and some of the ball: look at how "
                   "the samples are spread over such a pixel, and at their mean"});
}
