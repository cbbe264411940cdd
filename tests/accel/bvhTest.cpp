// How a tree is built.
#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "accel/bvhSupport.h"

using namespace sw;
using namespace test;

TEST_CASE("every primitive lies in one leaf and every box in its parent's") {
    const auto seed = GENERATE(range(0u, 140u));
    Random random(seed);
    const auto kind = static_cast<Kind>(seed % static_cast<unsigned>(Kind::kinds));
    const int n = seed < 40 ? random.whole(0, 40) : random.whole(0, 5000);
    const int leafSize = random.whole(1, 8);
    const float scale = std::ldexp(1.0f, random.whole(-30, 30));
    CAPTURE(seed, n, leafSize, scale);
    const auto boxes = randomBoxes(random, kind, n, scale);
    checkTree(Bvh(boxes, leafSize), boxes, leafSize);
}

TEST_CASE("no leaf holds primitives of two kinds") {
    Random random(GENERATE(range(0u, 60u)));
    const auto boxes = randomBoxes(random, static_cast<Kind>(0), random.whole(0, 1200), 1);
    const int most = GENERATE(1, 3, 1000);  // kinds
    std::vector<std::uint32_t> kinds;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        kinds.push_back(static_cast<std::uint32_t>(random.whole(1, most)));
    Bvh bvh(boxes, 8, 1, kinds);
    checkTree(bvh, boxes, 8);
    int mixed = 0;
    bvh.numberLeaves([&](std::span<const std::uint32_t> leaf) {
        for (const std::uint32_t i : leaf) mixed += kinds[i] != kinds[leaf[0]];
        return 0u;
    });
    CHECK(mixed == 0);
}

TEST_CASE("leaves bear the numbers that they are given") {
    Random random(3);
    const auto boxes = randomBoxes(random, Kind::scattered, 500, 1);
    Bvh bvh(boxes);
    std::vector<std::vector<std::uint32_t>> leaves;
    bvh.numberLeaves([&](std::span<const std::uint32_t> leaf) {
        leaves.emplace_back(leaf.begin(), leaf.end());
        return static_cast<std::uint32_t>(leaves.size() - 1);
    });
    CHECK(bvh.order().empty());
    int missed = 0;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Vec3 middle = (boxes[i].min + boxes[i].max) * 0.5f;
        bool reached = false;
        bvh.traverse(Ray(middle - Vec3(0, 0, 1), Vec3(0, 0, 1)),
                     [&](std::uint32_t number, std::uint32_t count, float&) {
                         const auto& leaf = leaves.at(number);
                         CHECK(leaf.size() == count);
                         reached |= std::find(leaf.begin(), leaf.end(), i) != leaf.end();
                         return false;
                     });
        missed += !reached;
    }
    CHECK(missed == 0);
}

TEST_CASE("only the tree's depth grows with its size") {
    const int few = 32, many = 1000;
    const Bvh small(terrain(few)), large(terrain(many));
    Random random(1);
    double smallNodes = 0, largeNodes = 0, largePrimitives = 0;
    const int rays = 2000;
    for (int k = 0; k < rays; ++k) {
        const Vec3 above(random.real(0, 1), random.real(0, 1), 3);
        const Vec3 target(random.real(0, 1), random.real(0, 1), 0);
        const Ray ray(above, (target - above) * (1 - 1e-3f));
        smallNodes += static_cast<double>(costOfMiss(small, ray).nodes);
        largeNodes += static_cast<double>(costOfMiss(large, ray).nodes);
        largePrimitives += static_cast<double>(costOfMiss(large, ray).primitives);
    }
    CAPTURE(smallNodes / rays, largeNodes / rays, largePrimitives / rays);
    CHECK(largeNodes < 3 * smallNodes);
    CHECK(largeNodes < 20 * rays);
    CHECK(largePrimitives < 50 * rays);
    const std::size_t bytes = large.tree().size_bytes() + large.order().size_bytes();
    CHECK(bytes < 25u * many * many);
}

TEST_CASE("a million equal boxes make a shallow tree") {
    const std::vector<Bounds> boxes(1'000'000, Bounds({1, 2, 3}, {4, 5, 6}));
    const Bvh bvh(boxes, 8, 2);
    checkTree(bvh, boxes, 8);
    Inspection inspection{bvh, boxes, 8};
    inspection.walk(0, Bounds::unbounded(), 1);
    CHECK(inspection.depth <= 7);
    CHECK(costOfMiss(bvh, Ray({0, 0, 0}, {2, 3, 4})).primitives == boxes.size());
    CHECK(costOfMiss(bvh, Ray({0, 0, 0}, {-2, 3, 4})).nodes == 1);
}

TEST_CASE("the tree is the same for any number of threads") {
    Random random(7);
    const auto boxes = randomBoxes(random, Kind::scattered, 50'000, 1);
    const Bvh one(boxes, 8, 1);
    checkTree(one, boxes, 8);
    const auto threads = GENERATE(2, 5);
    const Bvh several(boxes, 8, threads);
    const auto a = one.tree(), b = several.tree();
    REQUIRE(a.size() == b.size());
    CHECK(std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
    CHECK(std::equal(one.order().begin(), one.order().end(), several.order().begin()));
}

TEST_CASE("the children are sorted for every octant, the nearest last") {
    Random random(GENERATE(range(0u, 20u)));
    const auto boxes = randomBoxes(random, Kind::scattered, random.whole(1, 2000), 1);
    const Bvh bvh(boxes, 4);
    int twice = 0, outOfOrder = 0;
    for (const Bvh::Node& node : bvh.tree())
        for (unsigned octant = 0; octant < 8; ++octant)
            inspectOrder(node, octant, twice, outOfOrder);
    CHECK(twice == 0);  // for each side of the origin
    CHECK(outOfOrder == 0);
}

TEST_CASE("an empty tree finds nothing") {
    for (const Bvh& bvh : {Bvh(), Bvh(std::vector<Bounds>())}) {
        CHECK(bvh.order().empty());
        CHECK(bvh.tree().empty());
        CHECK(costOfMiss(bvh, Ray({0, 0, 0}, {0, 0, 1})).nodes == 0);
    }
    REQUIRE_THROWS_AS(Bvh({}, 0), std::invalid_argument);
    REQUIRE_THROWS_AS(Bvh({}, 9), std::invalid_argument);
}
