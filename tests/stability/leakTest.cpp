// Rays from inside a closed mesh, aimed at its corners, edges and faces, must hit it.
//
// Plain rays pass an edge at a random distance of some 2^-24, far more than the 2^-53 at which
// double precision errs. So half of the rays here are exact: origin, corners and the target, a
// quarter or a half of the way along an edge, lie on a grid, and the direction, their difference,
// is no rounded number. Such a ray meets the edge in exact arithmetic, while the products of the
// edge functions need 100 bits. Fused multiply-adds then give both neighbours the sign of the same
// rounding error, and where it says "outside" the ray slips through: these are the tests that fail
// when the library is compiled with -ffp-contract=fast for a machine with FMA.

#include <algorithm>

#include "stability/cases.h"
#include "stability/meshes.h"

using namespace sw;
using namespace test;

namespace {

// Fine enough for the products to need more than 53 bits; differences of corners fit a float.
constexpr float grid = 0x1p-20f;

Vec3 onGrid(const Vec3& v, float step) {
    return {std::round(v[0] / step) * step, std::round(v[1] / step) * step,
            std::round(v[2] / step) * step};
}

Mesh chosenMesh(int number) {
    Mesh mesh = number == 0 ? tetrahedron() : number == 1 ? cube() : icosphere(number - 2);
    // No two coordinates alike: turned out of the axes, and stretched.
    for (Vec3& v : mesh.vertices)
        v = {v[0] * 0.9f - v[1] * 0.3f, v[0] * 0.31f + v[1] * 0.83f, v[2] * 0.77f + v[0] * 0.1f};
    return mesh;
}

// Weights of a face's corners, in quarters: a corner, a point on an edge, or one inside.
std::array<float, 3> quarters(Random& random) {
    std::array<float, 3> w{0, 0, 0};
    const auto first = static_cast<std::size_t>(random.whole(0, 2));
    const int kind = random.whole(0, 9);
    const float part = kind == 0 ? 0 : static_cast<float>(random.whole(1, 3)) / 4;
    w[first] = 1 - part;
    w[(first + 1) % 3] = kind == 1 ? part - 0.25f : part;
    w[(first + 2) % 3] = kind == 1 ? 0.25f : 0;
    return w;
}

struct Rays {
    const Mesh& mesh;
    Vec3 center;
    float step;  // of the grid of exact rays; 0: plain rays

    Ray next(Random& random) const {
        const auto face =
            static_cast<std::size_t>(random.whole(0, static_cast<int>(mesh.faces.size()) - 1));
        const auto w = quarters(random);
        Vec3 target;
        for (int i = 0; i < 3; ++i) target += mesh.corner(face, i) * w[static_cast<std::size_t>(i)];
        Vec3 from = center + random.direction() * random.real(0, 0.2);
        if (step > 0) {
            from = onGrid(from, step);
            return {from, target - from};
        }
        return rayThrough(random, from, target);
    }
};

// The large meshes get fewer rays, in case that the scene looks through all of its faces.
int raysFor(const Mesh& mesh) {
    return std::clamp(static_cast<int>(20000000 / mesh.faces.size()), 1500, 60000);
}

void checkNoLeak(const Rays& rays, int count) {
    const Scene scene = toScene(rays.mesh);
    int leaks = 0;
    std::string first;
    constexpr unsigned seed = 1;
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        const Ray ray = rays.next(random);
        Intersection hit;
        if (!scene.intersect(ray, hit, random.coin()) && leaks++ == 0)
            first = describe("number", i, ray);
    }
    INFO(leaks << " leaks in " << count << " rays of seed " << seed << ", the first: " << first);
    CHECK(leaks == 0);
}

}  // namespace

TEST_CASE("no ray leaks out of a closed mesh") {
    const int number = GENERATE(range(0, 8));
    const Mesh mesh = chosenMesh(number);
    CAPTURE(number, mesh.faces.size());
    checkNoLeak({mesh, {0, 0, 0}, 0}, raysFor(mesh));
}

TEST_CASE("no ray leaks through the very middle of an edge") {
    const int number = GENERATE(range(0, 8));
    Mesh mesh = chosenMesh(number);
    for (Vec3& v : mesh.vertices) v = onGrid(v, 4 * grid);
    CAPTURE(number, mesh.faces.size());
    checkNoLeak({mesh, {0, 0, 0}, grid}, raysFor(mesh));
}

TEST_CASE("no ray leaks out of a mesh far from the origin") {
    const int number = GENERATE(range(0, 8));
    const float size = GENERATE(1.0f, 30.0f);
    const Vec3 center(1e5f, -1e5f, 9e4f);
    Mesh mesh = chosenMesh(number);
    for (Vec3& v : mesh.vertices) v = center + v * size;
    CAPTURE(number, size, mesh.faces.size());
    checkNoLeak({mesh, center, 0}, raysFor(mesh) / 2);
}
