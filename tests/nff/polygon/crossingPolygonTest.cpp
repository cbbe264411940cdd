#include <algorithm>

#include "nff/polygon/crossings.h"
#include "nff/polygon/polygons.h"
#include "nff/polygon/triangulate.h"

using namespace sw;
using namespace test;

TEST_CASE("a polygon that crosses itself is reported and still triangulated") {
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

TEST_CASE("a polygon that is not planar is reported and still triangulated") {
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

TEST_CASE("a polygon rounded far from the origin counts as planar") {
    const auto seed = GENERATE(range(0u, 100u));
    CAPTURE(seed);
    Random random(seed);
    Placement placed(random);
    placed.scale = 1;
    placed.offset *= 1e5 / glm::length(placed.offset);
    CHECK(triangulate(placed(star(9, [](int) { return 1.0; }))).planar);
}

TEST_CASE("lines, points and corners that are not finite give no triangles") {
    const float bad = GENERATE(NAN, HUGE_VALF, -HUGE_VALF);
    CHECK(triangulate({}).triangles.empty());
    CHECK(triangulate(Polygon(2)).triangles.empty());
    CHECK(triangulate(Polygon(1000, Vec3(1, 2, 3))).triangles.empty());
    Polygon line;
    for (int i = 0; i < 1000; ++i) line.push_back(Vec3(1, 2, 4) * (i * 7 % 100));
    CHECK(triangulate(line).triangles.empty());
    CHECK(triangulate(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {bad, 1, 0}}).triangles.empty());
}

TEST_CASE("the work on crossing polygons is at most quadratic") {
    Random random(1);
    Polygon polygon;
    for (int i = 0; i < 10000; ++i)
        polygon.push_back(Vec3(random.real(0, 1), random.real(0, 1), 0));
    const Triangulation cut = triangulate(polygon);
    CHECK(cut.steps <= polygon.size() * polygon.size());
    CHECK(usedCorners(polygon, cut) == polygon.size());
}

namespace {

// In whole numbers, of all pairs of sides.
bool crossesAnywhere(const std::vector<Point2>& polygon) {
    const auto sideOf = [](const Point2& a, const Point2& b, const Point2& c) {
        const auto whole = [](double x) { return static_cast<int>(x); };
        const int turn = whole(b.x - a.x) * whole(c.y - a.y) - whole(b.y - a.y) * whole(c.x - a.x);
        return (turn > 0) - (turn < 0);
    };
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
            const Point2 &c = polygon[k], &d = polygon[(k + 1) % polygon.size()];
            if (sideOf(a, b, c) * sideOf(a, b, d) < 0 && sideOf(c, d, a) * sideOf(c, d, b) < 0)
                return true;
        }
    return false;
}

}  // namespace

TEST_CASE("sides cross where integer arithmetic says so, and not where they touch or coincide") {
    int crossing = 0;
    for (unsigned seed = 0; seed < 5000; ++seed) {
        Random random(seed);
        std::vector<Point2> polygon;
        const int size = random.whole(1, 20);
        for (int i = random.whole(3, 9); i > 0; --i)
            polygon.push_back({1.0 * random.whole(0, size), 1.0 * random.whole(0, size)});
        CAPTURE(seed);
        CHECK(hasCrossings(polygon) == crossesAnywhere(polygon));
        crossing += crossesAnywhere(polygon);
    }
    CHECK(crossing > 1000);
    CHECK(crossing < 4500);
}
