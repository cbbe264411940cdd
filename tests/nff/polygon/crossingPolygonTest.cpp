#include <algorithm>

#include "nff/polygon/polygons.h"
#include "nff/polygon/triangulate.h"

using namespace sw;
using namespace test;

TEST_CASE("a polygon that crosses itself is reported and cut all the same") {
    const Polygon bowtie = {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}};
    const Polygon pentagram = star(
        5, [](int) { return 1.0; }, 2);
    // A ribbon whose end lies across its beginning, with no corner inside of it.
    const Polygon ribbon = {{0, 0, 0},  {9, 0, 0}, {9, 9, 0}, {3, 9, 0}, {3, -3, 0},
                            {4, -3, 0}, {4, 8, 0}, {8, 8, 0}, {8, 1, 0}, {0, 1, 0}};
    // All triangles around the first corner turn left, one and a half times round.
    Polygon snail = star(
        20, [](int i) { return 1 + i; }, 2);
    snail.resize(15);
    snail[0] = Vec3();
    const Polygon polygon = GENERATE_COPY(bowtie, pentagram, ribbon, snail);
    for (const Polygon& turned : {polygon, Placement::upright(polygon)}) {
        const Triangulation cut = triangulate(turned);
        CHECK_FALSE(cut.simple);
        CHECK(cut.planar);
        CHECK(cut.triangles.size() == polygon.size() - 2);
        CHECK(usedCorners(polygon, cut) == polygon.size());
    }
}

TEST_CASE("random crossing polygons are reported and keep their corners") {
    const auto seed = GENERATE(range(0u, 200u));
    Random random(seed);
    Polygon polygon;
    const int count = random.whole(30, 200);
    for (int i = 0; i < count; ++i)
        polygon.push_back(Vec3(random.real(0, 1), random.real(0, 1), 0));
    CAPTURE(seed, count);
    const Triangulation cut = triangulate(polygon);
    CHECK_FALSE(cut.simple);
    CHECK(usedCorners(polygon, cut) == polygon.size());
}

TEST_CASE("a polygon out of plane is reported and cut all the same") {
    const auto seed = GENERATE(range(0u, 100u));
    Random random(seed);
    Polygon polygon = star(random.whole(4, 40), [&](int) { return random.uniform(1, 2); });
    const auto bent = static_cast<std::size_t>(random.whole(0, 3));
    CAPTURE(seed, polygon.size());
    polygon[bent][2] = 1e-4f;
    CHECK(triangulate(polygon).planar);
    polygon[bent][2] = 0.1f;
    const Triangulation cut = triangulate(polygon);
    CHECK_FALSE(cut.planar);
    CHECK(usedCorners(polygon, cut) == polygon.size());
}

TEST_CASE("rounding far from the origin is not out of plane") {
    const auto seed = GENERATE(range(0u, 100u));
    CAPTURE(seed);
    Random random(seed);
    Placement placed(random);
    placed.scale = 1;
    placed.offset *= 1e5 / glm::length(placed.offset);
    CHECK(triangulate(placed(star(9, [](int) { return 1.0; }))).planar);
}

TEST_CASE("nothing is left of a line, a point or numbers that are not finite") {
    const float bad = GENERATE(NAN, HUGE_VALF, -HUGE_VALF);
    CHECK(triangulate({}).triangles.empty());
    CHECK(triangulate(Polygon(2)).triangles.empty());
    CHECK(triangulate(Polygon(1000, Vec3(1, 2, 3))).triangles.empty());
    Polygon line;
    for (int i = 0; i < 1000; ++i) line.push_back(Vec3(1, 2, 4) * (i * 7 % 100));
    CHECK(triangulate(line).triangles.empty());
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {bad, 1, 0}}).triangles.empty());
}

TEST_CASE("the work on crossing polygons is bounded") {
    Random random(1);
    Polygon polygon;
    for (int i = 0; i < 20000; ++i)
        polygon.push_back(Vec3(random.real(0, 1), random.real(0, 1), 0));
    const Triangulation cut = triangulate(polygon);
    CHECK(cut.steps <= 100 * polygon.size());
    CHECK(usedCorners(polygon, cut) == polygon.size());
}
