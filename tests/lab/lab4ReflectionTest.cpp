#include "lab/mirrors.h"

using namespace lab;
using namespace sw;

// getReflectedRay(), asked directly.

namespace {

struct Mirrored {
    Vec3 in, normal, out;  // out as a unit vector
};

// d: the unit direction of the ray that comes in.
std::string directionHint(const Ray& got, const Vec3& d, const Mirrored& m) {
    if (isEmpty(got)) {
        return "getReflectedRay() in swIntersection.cpp still returns an empty "
               "ray: this is where task 4 begins";
    }
    if (!isNumber(got.dir)) return "only sums and products are needed here: where is a NaN born?";
    const Vec3 g = unit(got.dir);
    if (alike(g, m.out)) {
        return "it goes the right way, but a reflected ray has a direction of length 1, however "
               "long the one was that came in";
    }
    return hintFor(
        g,
        {{-m.out,
          "every sign is the wrong way round: this is where the mirrored ray would come "
          "from, not where it goes"},
         {unit(2 * d - m.out),
          "this ray is reflected about the wrong side and dives deeper into the surface: turn the "
          "part of the direction along the normal round, do not make it longer"},
         {unit(d + m.out),
          "this ray slides along the surface: you took the part along the normal away once, which "
          "only stops it; a mirror sends it back"},
         {d, "the ray goes on as if there were no mirror"},
         {-d, "the ray goes back the way it came; a mirror does so only when it is met head-on"}},
        g * m.normal < 0
            ? "this ray goes into the surface; a mirrored one stays on the side it came from"
            : "a mirror keeps the part of the direction along the surface and turns the part along "
              "the normal round");
}

void expectMirrored(const Mirrored& m) {
    const Ray got = hitBy(m.in, m.normal, opaque(1)).getReflectedRay();
    if (!isEmpty(got) && alike(got.dir, m.out)) return;
    fail({"getReflectedRay() of a ray with direction " + text(m.in) +
              " that meets a surface with normal " + text(m.normal),
          "the direction " + text(got.dir), text(m.out), directionHint(got, unit(m.in), m)});
}

constexpr float diagonal = 0.70710678f;

}  // namespace

TEST_CASE("a mirror met at 45 degrees turns a ray by a right angle", "[lab4]") {
    const Vec3 up(0, 1, 0);
    expectMirrored({{diagonal, -diagonal, 0}, up, {diagonal, diagonal, 0}});
    expectMirrored({{0, -diagonal, -diagonal}, up, {0, diagonal, -diagonal}});
    expectMirrored({{-1, 0, 0}, {diagonal, diagonal, 0}, {0, 1, 0}});
    expectMirrored({{0, 0, 1}, {diagonal, 0, -diagonal}, {1, 0, 0}});
}

TEST_CASE("mirrored directions come out as drawn on squared paper", "[lab4]") {
    expectMirrored({{0.6f, -0.8f, 0}, {0, 1, 0}, {0.6f, 0.8f, 0}});
    expectMirrored({{0.8f, 0, 0.6f}, {0, 0, -1}, {0.8f, 0, -0.6f}});
    expectMirrored({{-5 / 13.f, 0, 12 / 13.f}, {1, 0, 0}, {5 / 13.f, 0, 12 / 13.f}});
    expectMirrored({{0, -1, 0}, {0.6f, 0.8f, 0}, {0.96f, 0.28f, 0}});
    const float third = 0.57735027f;
    expectMirrored({{-1, 0, 0}, {third, third, third}, {-1 / 3.f, 2 / 3.f, 2 / 3.f}});
}

TEST_CASE("a ray that meets a mirror head-on goes back the way it came", "[lab4]") {
    test::Random random(1);
    for (int i = 0; i < 20; ++i) {
        const Vec3 n = random.direction();
        expectMirrored({-n, n, n});
    }
}

TEST_CASE("a ray that grazes a mirror flies on close to it", "[lab4]") {
    for (const float height : {0.1f, 0.01f, 0.001f}) {
        expectMirrored({unit({1, -height, 0}), {0, 1, 0}, unit({1, height, 0})});
        expectMirrored({unit({height, 0.8f, 0.6f}), {-1, 0, 0}, unit({-height, 0.8f, 0.6f})});
    }
}

TEST_CASE("a mirrored ray leaves at the angle at which it came and in the same plane", "[lab4]") {
    test::Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Vec3 n = random.direction();
        const Vec3 sideways = random.real(0.1, 1) * along(n, random);
        const Vec3 upwards = random.real(0.1, 1) * n;
        expectMirrored({unit(sideways - upwards), n, unit(sideways + upwards)});
    }
}

TEST_CASE("the length of the incoming direction does not matter to a mirror", "[lab4]") {
    for (const float length : {0.001f, 0.5f, 3.f, 1000.f}) {
        expectMirrored({length * Vec3(0.6f, -0.8f, 0), {0, 1, 0}, {0.6f, 0.8f, 0}});
    }
}

namespace {

const Sphere ball(Vec3(3, -2, 7), 5, opaque(1));

Vec3 pointOnBall(test::Random& random) {
    return ball.center + ball.radius * random.direction();
}

// The points of 1000 random ones from which the mirrored ray goes wrong, as told by `wrong`.
template <typename Wrong>
int countWrong(bool inside, Wrong wrong) {
    test::Random random(3);
    int sum = 0, asked = 0;
    while (asked < 1000) {
        const Vec3 from = inside ? pointOnBall(random) : ball.center + 20 * random.direction();
        Ray ray(from, pointOnBall(random) - from, inside ? 0.01f : 0);
        Intersection hit;
        // Hits that graze the ball leave no room for doubt: rounding alone may decide them.
        if (!ball.intersect(ray, hit) || unit(ray.dir) * hit.normal > -0.1f) continue;
        ++asked;
        sum += wrong(hit, hit.getReflectedRay());
    }
    return sum;
}

std::string outOfAThousand(int count, const std::string& what) {
    return std::to_string(count) + " of 1000 " + what;
}

const std::string notYet = "getReflectedRay() in swIntersection.cpp returns an empty ray";

}  // namespace

TEST_CASE("a ray mirrored by a ball never hits that ball again", "[lab4]") {
    int empty = 0;
    const int again = countWrong(false, [&](const Intersection&, const Ray& mirrored) {
        Intersection hit;
        empty += isEmpty(mirrored);
        return isEmpty(mirrored) || ball.intersect(mirrored, hit);
    });
    if (again == 0) return;
    fail({"rays mirrored by a ball from outside",
          outOfAThousand(again, empty > 0 ? "are empty" : "hit the same ball again"), "none",
          empty > 0 ? notYet
                    : "rounding puts many hit points just below the surface: start the "
                      "mirrored ray a little way off it, on the side that the ray came from"});
}

TEST_CASE("a mirrored ray starts where the surface was hit", "[lab4]") {
    int empty = 0;
    const int astray = countWrong(false, [&](const Intersection& hit, const Ray& mirrored) {
        empty += isEmpty(mirrored);
        const Vec3 start = mirrored.orig + mirrored.minT * mirrored.dir;
        return isEmpty(mirrored) || !alike(start, hit.position, 0.05f) || mirrored.maxT < 1e6f;
    });
    if (astray == 0) return;
    fail({"rays mirrored by a ball of radius 5",
          outOfAThousand(astray, empty > 0 ? "are empty" : "start far from the hit or end early"),
          "none", empty > 0 ? notYet : "a mirrored ray begins at the hit and goes on for ever"});
}

TEST_CASE("inside a hollow mirror all mirrored paths are equally long", "[lab4]") {
    // The chords of a sphere that meet it at one angle.
    int empty = 0;
    const int wrong = countWrong(true, [&](const Intersection& hit, const Ray& mirrored) {
        empty += isEmpty(mirrored);
        Intersection next;
        if (isEmpty(mirrored) || !ball.intersect(mirrored, next)) return true;
        const float before = (hit.position - hit.ray.orig).norm();
        return !(std::fabs((next.position - hit.position).norm() - before) < 0.01f);
    });
    if (wrong == 0) return;
    fail({"rays mirrored by a ball from inside",
          outOfAThousand(wrong, empty > 0 ? "are empty" : "take a path of another length"), "none",
          empty > 0 ? notYet
                    : "the normal in the hit record is on the side that the ray came from, inside "
                      "as well as outside: there is nothing left to turn round"});
}
