#include "accel/trianglePacket.h"

#include <bit>
#include <numeric>

#include "support.h"
#include "testScenes.h"

using namespace sw;
using namespace test;

namespace {

std::vector<std::uint32_t> numbersTo(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
}

// Bit by bit, which of up to eight shapes the filter lets through.
template <typename Shape>
unsigned candidates(const std::vector<Shape>& shapes, const Ray& ray) {
    std::vector<float> rows(Rows<Shape>::count * simd::lanes + simd::lanes);
    for (std::size_t i = 0; i < shapes.size(); ++i)
        Rows<Shape>::write(shapes[i], {&rows[i], shapes.size()});
    const FilterRay prepared(ray);
    return ~Rows<Shape>::filter(prepared, rows.data(), shapes.size()).missed() &
           ((1u << shapes.size()) - 1);
}

// Pushes a parallelogram, as the reader does with a polygon of four vertices.
void pushWall(std::vector<Triangle>& walls, const Vec3& corner, const Vec3& a, const Vec3& b) {
    const Vec3 v[] = {corner, corner + a, corner + a + b, corner + b};
    const Vec3 w[] = {v[0], v[2], v[3]};
    walls.emplace_back(v, Material());
    walls.emplace_back(w, Material());
}

// The room of the lab: floor, ceiling, back and two sides.
std::vector<Triangle> room() {
    const Vec3 wide(40, 0, 0), high(0, 40, 0), deep(0, 0, 100);
    std::vector<Triangle> walls;
    pushWall(walls, Vec3(-20, 0, -50), wide, deep);
    pushWall(walls, Vec3(-20, 40, -50), deep, wide);
    pushWall(walls, Vec3(-20, 0, -50), high, wide);
    pushWall(walls, Vec3(-20, 0, -50), deep, high);
    pushWall(walls, Vec3(20, 0, -50), high, deep);
    return walls;
}

}  // namespace

TEST_CASE("the ten triangles of a room take five lanes of one packet") {
    const std::vector<Triangle> walls = room();
    auto pending = numbersTo(walls.size());
    const TrianglePacket packet(walls, pending);
    CHECK(pending.empty());
}

TEST_CASE("triangles that make no parallelogram take a lane each") {
    Random random(GENERATE(range(0u, 20u)));
    std::vector<Triangle> triangles;
    for (int i = 0; i < 9; ++i) {
        const Vec3 v[] = {random.point(1), random.point(1), random.point(1)};
        triangles.emplace_back(v, Material());
    }
    auto pending = numbersTo(triangles.size());
    const TrianglePacket first(triangles, pending);
    REQUIRE(pending == std::vector<std::uint32_t>{8});
    const TrianglePacket second(triangles, pending);
    CHECK(pending.empty());
}

TEST_CASE("a ray in a room is tested against few shapes that it misses") {
    const std::vector<Triangle> walls = room();
    auto pending = numbersTo(walls.size());
    const TrianglePacket packet(walls, pending);
    Random random(1);
    int tested = 0, hits = 0;
    for (int i = 0; i < 10000; ++i) {
        const Ray ray(Vec3(0, 20, 0) + random.point(19), random.direction());
        const FilterRay prepared(ray);
        std::vector<int> found(walls.size());
        for (unsigned left = packet.bits() & ~packet.filter(prepared).missed(); left != 0;
             left &= left - 1)
            ++found[packet.number(static_cast<std::uint32_t>(std::countr_zero(left)))];
        for (std::size_t k = 0; k < walls.size(); ++k) {
            Intersection hit;
            const bool isHit = walls[k].intersect(ray, hit);
            tested += found[k];
            hits += isHit;
            CHECK(found[k] >= isHit);
        }
    }
    CHECK(hits > 8000);
    CHECK(tested <= hits + hits / 100);
}

TEST_CASE("a ray among spheres is tested against few shapes that it misses") {
    Random random(2);
    std::vector<Sphere> spheres;
    for (int i = 0; i < 8; ++i) spheres.emplace_back(random.point(5), 1.0f, Material());
    int tested = 0, hits = 0;
    for (int i = 0; i < 10000; ++i) {
        const Ray ray(random.point(8), random.direction());
        tested += std::popcount(candidates(spheres, ray));
        for (const Sphere& sphere : spheres) {
            Intersection hit;
            hits += sphere.intersect(ray, hit);
        }
    }
    CHECK(hits > 500);
    CHECK(tested <= hits + hits / 100);
}

TEST_CASE("a ray among cones is tested against few that it misses and all that it hits") {
    Random random(3);
    std::vector<Cone> cones;
    for (int i = 0; i < 8; ++i)
        cones.emplace_back(random.point(5), random.real(0, 0.3), random.point(5),
                           random.real(0, 0.3), Material());
    int tested = 0, hits = 0, missing = 0;
    for (int i = 0; i < 20000; ++i) {
        const Ray ray(random.point(8), random.direction() * random.magnitude(1e-3, 1e3));
        const unsigned found = candidates(cones, ray);
        tested += std::popcount(found);
        for (unsigned k = 0; k < cones.size(); ++k) {
            Intersection hit;
            if (!cones[k].intersect(ray, hit)) continue;
            ++hits;
            missing += (found >> k & 1) == 0;
        }
    }
    CAPTURE(tested, hits);
    CHECK(missing == 0);
    CHECK(hits > 500);
    CHECK(tested <= 5 * hits / 2);
}
