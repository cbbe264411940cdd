#include "nff/polygon/triangulate.h"

#include <algorithm>

#include "nff/polygon/orientation.h"
#include "nff/polygon/polygons.h"
#include "support.h"

using namespace sw;
using namespace test;

namespace {

// Twice the signed area, on the side that n points to.
double doubleArea(const Polygon& polygon, const dvec3& n) {
    dvec3 sum(0, 0, 0);
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += cross(toDouble(polygon[i - 1]) - toDouble(polygon[0]),
                     toDouble(polygon[i]) - toDouble(polygon[0]));
    return dot(sum, n);
}

Polygon cornersOf(const Polygon& polygon, const std::array<std::uint32_t, 3>& triangle) {
    return {polygon.at(triangle[0]), polygon.at(triangle[1]), polygon.at(triangle[2])};
}

// The sum of the triangles' areas, as a part of the polygon's. Every triangle must face the
// polygon's way: then the sum is 1 only if they neither overlap nor leave anything out.
double coverage(const Polygon& polygon, const Triangulation& cut, const dvec3& n) {
    double sum = 0, smallest = HUGE_VAL;
    for (const auto& triangle : cut.triangles) {
        const double area = doubleArea(cornersOf(polygon, triangle), n);
        smallest = std::min(smallest, area);
        sum += area;
    }
    CHECK(smallest > 0);
    return sum / doubleArea(polygon, n);
}

const dvec3 up(0, 0, 1);

void checkWholeCut(const Polygon& polygon, const Triangulation& cut, const dvec3& n = up) {
    CHECK(cut.planar);
    CHECK(cut.simple);
    CHECK(cut.triangles.size() == polygon.size() - 2);
    CHECK(usedCorners(polygon, cut) == polygon.size());
    CHECK(std::fabs(coverage(polygon, cut, n) - 1) <= 1e-9);
}

// No corner lies on a side of a triangle, but at its ends. For whole coordinates.
bool hasLooseCorner(const Polygon& polygon, const Triangulation& cut) {
    for (const auto& triangle : cut.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 a = polygon[triangle[i]], b = polygon[triangle[(i + 1) % 3]];
            for (const Vec3& p : polygon)
                if (((b - a) % (p - a)).norm() == 0 && (p - a) * (p - b) < 0) return true;
        }
    return false;
}

// Two triangles that share a side run along it in opposite directions, but for the outline's sides.
bool isClosed(const Polygon& polygon, const Triangulation& cut) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
    const auto count = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 0; i < count; ++i) open.push_back({(i + 1) % count, i});
    for (const auto& [a, b, c] : cut.triangles)
        for (const auto& side : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
            open.push_back(side);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> turned;
    for (const auto& [a, b] : open) turned.push_back({b, a});
    std::sort(open.begin(), open.end());
    std::sort(turned.begin(), turned.end());
    return open == turned;
}

}  // namespace

TEST_CASE("the triangles of a simple polygon cover it once") {
    const auto seed = GENERATE(range(0u, 500u));
    Random random(seed);
    const Polygon polygon = randomSimple(random, random.whole(4, 120));
    CAPTURE(seed, polygon.size());
    const Triangulation cut = triangulate(polygon);
    checkWholeCut(polygon, cut);
    CHECK(isClosed(polygon, cut));
}

TEST_CASE("a polygon may start at any of its corners") {
    const auto seed = GENERATE(range(0u, 40u));
    Random random(seed);
    Polygon polygon = randomSimple(random, random.whole(4, 24));
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        CAPTURE(seed, i);
        checkWholeCut(polygon, triangulate(polygon));
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
}

TEST_CASE("a polygon may lie in any plane and be of any size") {
    const auto seed = GENERATE(range(0u, 500u));
    Random random(seed);
    const Polygon flat = randomSimple(random, random.whole(4, 60));
    const Placement placed(random);
    CAPTURE(seed, placed.scale);
    const Polygon polygon = placed(flat);
    const Triangulation cut = triangulate(polygon);
    checkWholeCut(polygon, cut, placed.normal);
}

TEST_CASE("a polygon in the opposite direction faces the other way") {
    const auto seed = GENERATE(range(0u, 50u));
    CAPTURE(seed);
    Random random(seed);
    Polygon polygon = randomSimple(random, random.whole(4, 60));
    std::reverse(polygon.begin(), polygon.end());
    checkWholeCut(polygon, triangulate(polygon), -up);
}

// On the line y = 3x every float of 22 bits has an exact point, near 0 and far away.
TEST_CASE("the orientation of three points is never wrong") {
    const auto seed = GENERATE(range(0u, 2000u));
    CAPTURE(seed);
    Random random(seed);
    const auto onLine = [&] {
        const double x = std::ldexp(random.whole(1, (1 << 22) - 1), random.whole(-60, 60));
        return random.coin() ? Point2{x, 3 * x} : Point2{-x, -3 * x};
    };
    const Point2 a = onLine(), b = onLine();
    Point2 c = onLine();
    CHECK(orientation(a, b, c) == 0);
    const bool isAbove = random.coin();
    c.y = std::nextafter(static_cast<float>(c.y), isAbove ? HUGE_VALF : -HUGE_VALF);
    if (a == b) return;
    const bool isLeft = isAbove == (a.x < b.x);
    CHECK((orientation(a, b, c) > 0) == isLeft);
    CHECK((orientation(b, c, a) > 0) == isLeft);
    CHECK((orientation(b, a, c) < 0) == isLeft);
}

TEST_CASE("a convex polygon becomes the fan around its first corner") {
    const int count = GENERATE(3, 4, 5, 8, 144, 10000);
    const Triangulation cut = triangulate(star(count, [](int) { return 3.0; }));
    REQUIRE(cut.triangles.size() == static_cast<std::size_t>(count - 2));
    CHECK(cut.steps == 0);
    for (std::uint32_t i = 0; i < cut.triangles.size(); ++i)
        CHECK((cut.triangles[i] == std::array{0u, i + 1, i + 2}));
}

TEST_CASE("corners on a straight side stay corners") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    Polygon polygon = subdivided(random, {{0, 0, 0}, {60, 0, 0}, {60, 60, 0}, {0, 60, 0}});
    if (random.coin())
        polygon = subdivided(random, {{0, 0, 0}, {60, 0, 0}, {60, 60, 0}, {30, 15, 0}, {0, 60, 0}});
    const int start = random.whole(0, static_cast<int>(polygon.size()) - 1);
    std::rotate(polygon.begin(), polygon.begin() + start, polygon.end());
    const Triangulation cut = triangulate(polygon);
    checkWholeCut(polygon, cut);
    CHECK_FALSE(hasLooseCorner(polygon, cut));
    CHECK(isClosed(polygon, cut));
}

TEST_CASE("repeated corners change nothing") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    const Polygon polygon = randomSimple(random, random.whole(4, 30));
    Polygon repeated;
    for (const Vec3& p : polygon)
        for (int i = random.whole(1, 3); i > 0; --i) repeated.push_back(p);
    const Triangulation cut = triangulate(repeated);
    CHECK(cut.simple);
    CHECK(cut.triangles.size() == polygon.size() - 2);
    CHECK(std::fabs(coverage(repeated, cut, up) - 1) <= 1e-9);
}

TEST_CASE("a spike without area changes nothing") {
    const Polygon square = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    const Vec3 tip = GENERATE(Vec3(1, 1, 0), Vec3(-3, -3, 0), Vec3(-1, 0, 0), Vec3(2, 0, 0));
    CAPTURE(tip);
    for (std::ptrdiff_t i = 0; i < 5; ++i) {
        Polygon polygon = {square[0], tip, square[0], square[1], square[2], square[3]};
        std::rotate(polygon.begin(), polygon.begin() + i, polygon.end());
        const Triangulation cut = triangulate(polygon);
        CHECK(cut.simple);
        CHECK(std::fabs(coverage(polygon, cut, up) - 1) <= 1e-9);
    }
}

TEST_CASE("holes on bridges are left out") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    Polygon polygon = keyholes(random, random.whole(1, 12));
    const int start = random.whole(0, static_cast<int>(polygon.size()) - 1);
    std::rotate(polygon.begin(), polygon.begin() + start, polygon.end());
    const Triangulation cut = triangulate(polygon);
    checkWholeCut(polygon, cut);
    CHECK_FALSE(hasLooseCorner(polygon, cut));
}

TEST_CASE("lobes may touch in a corner") {
    const Polygon hourglass = {{0, 0, 0}, {2, 2, 0}, {4, 0, 0}, {4, 5, 0}, {2, 2, 0}, {0, 5, 0}};
    const Polygon wings = {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {0, 0, 0}, {2, 4, 0}, {1, 5, 0}};
    const Polygon hole = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 0, 0}, {4, 3, 0}, {4, 2, 0}};
    Polygon polygon = GENERATE_COPY(hourglass, wings, hole);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        CAPTURE(i);
        const Triangulation cut = triangulate(polygon);
        CHECK(cut.simple);
        CHECK(std::fabs(coverage(polygon, cut, up) - 1) <= 1e-9);
        std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
}

TEST_CASE("the work on large polygons is at most quadratic") {
    for (const auto& [name, make] : largePolygons()) {
        CAPTURE(name);
        const Polygon polygon = make(10000);
        const Triangulation cut = triangulate(polygon);
        checkWholeCut(polygon, cut);
        CHECK(cut.steps <= polygon.size() * polygon.size());
    }
}

TEST_CASE("touching triangles around a corner are cut, however many") {
    Polygon polygon;
    for (int i = 0; i < 3000; ++i)
        for (const Vec3& corner :
             {Vec3(1, -1, 0), polar(1, 1 - i / 3000.0), polar(1, 1 - (i + 0.5) / 3000.0)})
            polygon.push_back(corner);
    std::reverse(polygon.begin(), polygon.end());
    const Triangulation cut = triangulate(polygon);
    CHECK(cut.simple);
    CHECK(cut.triangles.size() == 3000);
    CHECK(std::fabs(coverage(polygon, cut, up) - 1) <= 1e-9);
}
