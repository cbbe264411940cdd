#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "swNff.h"
#include "tools/common/scenes/scenes.h"
#include "tools/generatedShapes.h"

using namespace test;

namespace {

int overlaps(const std::vector<Ball>& balls) {
    int count = 0;
    for (const Ball& a : balls)
        for (const Ball& b : balls) count += &a < &b && gap(a, b) < -1e-6;
    return count;
}

using Point = std::array<double, 3>;

// Every edge in the direction in which its triangle goes round, with how often it does.
std::map<std::pair<Point, Point>, int> edges(const std::vector<Corners>& triangles) {
    const auto key = [](const dvec3& p) { return Point{p.x, p.y, p.z}; };
    std::map<std::pair<Point, Point>, int> count;
    for (const Corners& t : triangles)
        for (int i = 0; i < 3; ++i) ++count[{key(t.v[i]), key(t.v[(i + 1) % 3])}];
    return count;
}

// How many edges are used twice in one direction, or lack their other side.
template <typename AtBorder>
int openEdges(const std::vector<Corners>& triangles, const AtBorder& atBorder) {
    const auto all = edges(triangles);
    int open = 0;
    for (const auto& [edge, count] : all) {
        const bool closed = all.count({edge.second, edge.first}) == 1;
        open += count != 1 || (!closed && !atBorder(edge.first, edge.second));
    }
    return open;
}

std::set<Point> vertices(const std::vector<Corners>& triangles) {
    std::set<Point> result;
    for (const auto& [edge, count] : edges(triangles)) result.insert(edge.first);
    return result;
}

std::size_t power(std::size_t base, int exponent) {
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

}  // namespace

namespace {

// How many shapes a scene has.
std::size_t sizeOf(const std::string& name, int size) {
    const auto n = static_cast<std::size_t>(size);
    if (name == "balls") return (power(9, size + 1) - 1) / 8 + 1;
    if (name == "tetra") return power(4, size);
    if (name == "mount") return 2 * power(4, size) + 4;
    if (name == "rings") return 10 * n * (n + 1) * (2 * n + 1) + 1;
    return 2 * (power(2, size + 1) - 1) + 1;  // tree
}

}  // namespace

TEST_CASE("a generated scene is read, and has as many shapes as its size says") {
    for (const auto& [name, shows, least, most, usual, generate] : scenes::generators) {
        for (int size = least; size <= usual; ++size) {
            CAPTURE(name, size);
            const std::string text = generate(size);
            const sw::NffScene file = sw::parseNff(text, name);
            CHECK((file.width == 512 && file.height == 512));
            CHECK(Shapes(text).count() == sizeOf(name, size));
        }
    }
    CHECK(Shapes(scenes::balls(4)).count() == 7382);
    CHECK(Shapes(scenes::tetra(6)).count() == 4096);
    CHECK(Shapes(scenes::mount(6)).count() == 8196);
    CHECK(Shapes(scenes::rings(7)).count() == 8401);
    CHECK(Shapes(scenes::tree(11)).count() == 8191);
}

TEST_CASE("the same size gives the same text") {
    for (const auto& scene : scenes::generators)
        CHECK(scene.generate(scene.usual) == scene.generate(scene.usual));
}

TEST_CASE("every sphere of a flake but the first stands on one of three times its size") {
    const Shapes flake(scenes::balls(3));
    CHECK(overlaps(flake.balls) == 0);
    for (const Ball& parent : flake.balls) {
        int children = 0;
        for (const Ball& ball : flake.balls)
            children += std::fabs(3 * ball.radius - parent.radius) < 1e-6 &&
                        std::fabs(gap(ball, parent)) < 1e-6;
        CHECK(children == (parent.radius < 0.5 / 27 + 1e-6 ? 0 : 9));
    }
}

TEST_CASE("a flake grows six spheres at the waist and three above, and stays above its ground") {
    int waist = 0, above = 0;
    const Shapes small(scenes::balls(1));
    for (const Ball& ball : small.balls) {
        waist += ball.radius < 0.4 && ball.center.z == 0;
        above += std::fabs(ball.center.z - 2.0 / 3 * std::sqrt(2.0 / 3)) < 1e-6;
        // All ten as far apart as in the densest packing: 60 degrees as the first one sees it.
        for (const Ball& other : small.balls)
            CHECK((&other == &ball || glm::distance(ball.center, other.center) > 2.0 / 3 - 1e-6));
    }
    CHECK((waist == 6 && above == 3));
    for (const Ball& ball : Shapes(scenes::balls(4)).balls)
        CHECK(ball.center.z - ball.radius > -0.5 - 1e-6);
}

TEST_CASE("a pyramid is made of closed, equal, regular tetrahedra in a cube") {
    const int size = GENERATE(1, 2, 5);
    const Shapes pyramid(scenes::tetra(size));
    const double side = 2 * std::sqrt(2.0) / std::pow(2, size - 1);
    for (const Corners& t : pyramid.triangles)
        for (int i = 0; i < 3; ++i) {
            CHECK(std::fabs(glm::distance(t.v[i], t.v[(i + 1) % 3]) - side) < 1e-6);
            const dvec3 away = abs(t.v[i]);
            CHECK(std::max(away.x, std::max(away.y, away.z)) <= 1);
        }
    CHECK(openEdges(pyramid.triangles, [](auto&&...) { return false; }) == 0);
    CHECK(vertices(pyramid.triangles).size() == 2 * power(4, size - 1) + 2);
}

TEST_CASE("a mountain is one surface over a square, without gaps or overhangs") {
    const Shapes mountain(scenes::mount(5));
    double area = 0;
    for (const auto& [v] : mountain.triangles) {
        const double twice = glm::cross(v[1] - v[0], v[2] - v[0]).z;
        CHECK(twice > 0);  // seen from above it goes round counter-clockwise
        area += twice / 2;
    }
    CHECK(std::fabs(area - 4) < 1e-9);
    const auto onSide = [](const Point& a, const Point& b, std::size_t axis) {
        return a[axis] == b[axis] && std::fabs(a[axis]) == 1;
    };
    const auto atBorder = [&](const Point& a, const Point& b) {
        return onSide(a, b, 0) || onSide(a, b, 1);
    };
    CHECK(openEdges(mountain.triangles, atBorder) == 0);
}

TEST_CASE("a finer mountain goes through all points of a coarser one, and differs in between") {
    const auto coarse = vertices(Shapes(scenes::mount(4)).triangles);
    const auto fine = vertices(Shapes(scenes::mount(5)).triangles);
    CHECK(fine.size() == 33 * 33);
    for (const Point& p : coarse) CHECK(fine.count(p) == 1);
    std::set<double> heights;
    for (const Point& p : fine) heights.insert(p[2]);
    CHECK(heights.size() > fine.size() - 10);
}

TEST_CASE("the glass spheres hover apart above the mountain") {
    const Shapes mountain(scenes::mount(6));
    for (const Ball& a : mountain.balls)
        for (const Ball& b : mountain.balls) CHECK((&a == &b || gap(a, b) > 0.1));
    for (const Ball& ball : mountain.balls)
        for (const Point& p : vertices(mountain.triangles))
            if (std::hypot(p[0] - ball.center.x, p[1] - ball.center.y) < ball.radius + 0.05)
                CHECK(p[2] < ball.center.z - ball.radius);
}

TEST_CASE("lights and surfaces are those of the published scenes") {
    const auto below = [](const sw::NffScene& file, float x, float y) {
        sw::Intersection hit;
        REQUIRE(file.scene.intersect(sw::Ray(Vec3(x, y, 9), Vec3(0, 0, -1)), hit));
        return hit.material;
    };
    const auto balls = sw::parseNff(scenes::balls(2), ""),
               tetra = sw::parseNff(scenes::tetra(2), "");
    const auto mount = sw::parseNff(scenes::mount(2), "");
    CHECK(balls.scene.lights().size() == 3);
    CHECK((tetra.scene.lights().size() == 1 && mount.scene.lights().size() == 1));
    CHECK(below(balls, 0, 0).reflectivity == 0.5f);
    CHECK(distance(below(balls, 0, 0).color, Color(1, 0.9f, 0.7f)) < 1e-6);
    CHECK(distance(below(balls, 11, -11).color, 0.8f * Color(1, 0.75f, 0.33f)) < 1e-6);
    CHECK(distance(below(tetra, 0.7f, 0.7f).color, Color(1, 0.2f, 0.2f)) < 1e-6);
    const sw::Material glass = below(mount, -0.6f, 0.9f), rock = below(mount, 0.5f, -0.5f);
    CHECK(std::fabs(glass.reflectivity - 0.1f) < 0.0005f);  // they make way for the diffuse part
    CHECK(std::fabs(glass.transparency - 0.9f) < 0.0005f);
    const float diffuse = 1 - glass.reflectivity - glass.transparency;
    CHECK(distance(diffuse * glass.color, Color(0.1f, 0.1f, 0.1f)) < 1e-6);
    CHECK(glass.refractiveIndex == 1.5f);
    CHECK((rock.reflectivity == 0 && rock.transparency == 0));
}
