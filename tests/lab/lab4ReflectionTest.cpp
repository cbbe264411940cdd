#include "lab/mirrorModels.h"

using namespace lab;
using namespace sw;

// getReflectedRay(), asked directly.

namespace {

struct Mirrored {
    Vec3 in, normal, out;  // out as a unit vector
};

void expectMirrored(const Mirrored& m) {
    const Meeting meeting{unit(m.in), m.normal, true, m.in.norm()};
    const Ray got = hitBy(m.in, m.normal, opaque(1)).getReflectedRay();
    if (!isEmpty(got) && alike(got.dir, m.out)) return;
    const bool isUnit = std::fabs(meeting.length - 1) < 1e-4f;
    fail({"getReflectedRay() of a ray with direction " + text(m.in) +
              " that meets a surface with normal " + text(m.normal),
          "the direction " + text(got.dir), text(m.out),
          isUnit ? mirrorHint(got, meeting) : mirrorLengthHint(got, meeting)});
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
// @param asked  for a hint, about each of them
template <typename Wrong, typename Hint>
Verdict judge(bool inside, Wrong wrong, Hint hint) {
    test::Random random(3);
    Verdict verdict;
    for (int asked = 0; asked < 1000;) {
        const Vec3 from = inside ? pointOnBall(random) : ball.center + 20 * random.direction();
        const Ray ray(from, unit(pointOnBall(random) - from), inside ? 0.01f : 0);
        Intersection hit;
        // Hits that graze the ball leave no room for doubt: rounding alone may decide them.
        if (!ball.intersect(ray, hit) || ray.dir * hit.normal > -0.1f) continue;
        ++asked;
        const Ray mirrored = hit.getReflectedRay();
        if (isEmpty(mirrored) || wrong(hit, mirrored)) verdict.add(hint(hit, mirrored));
    }
    return verdict;
}

// Why a ray goes wrong: its direction, else its start.
std::string rayHint(const Intersection& hit, const Ray& mirrored) {
    const Meeting meeting{hit.ray.dir, hit.normal, hit.frontFacing};
    if (isStarters(mirrored)) return reflectionNotYet;
    if (agree(heading(mirrored.dir), meeting.mirrored()))
        return startHint(mirrored, hit, hit.normal, "mirrored");
    return mirrorHint(mirrored, meeting);
}

void expectNone(const std::string& tried, const Verdict& verdict, const std::string& what) {
    if (verdict.wrong() == 0) return;
    const bool empty = verdict.hint() == reflectionNotYet;
    fail({tried, std::to_string(verdict.wrong()) + " of 1000 " + (empty ? "are empty" : what),
          "none", verdict.hint()});
}

}  // namespace

TEST_CASE("a ray mirrored by a ball never hits that ball again", "[lab4]") {
    const auto again = [](const Intersection&, const Ray& mirrored) {
        Intersection hit;
        return ball.intersect(mirrored, hit);
    };
    expectNone("rays mirrored by a ball from outside", judge(false, again, rayHint),
               "hit the same ball again");
}

TEST_CASE("a mirrored ray starts where the surface was hit", "[lab4]") {
    const auto astray = [](const Intersection& hit, const Ray& mirrored) {
        return !alike(startOf(mirrored), hit.position, 0.05f) || mirrored.maxT < 1e6f;
    };
    const auto hint = [](const Intersection& hit, const Ray& mirrored) {
        return isStarters(mirrored) ? reflectionNotYet
                                    : startHint(mirrored, hit, hit.normal, "mirrored");
    };
    expectNone("rays mirrored by a ball of radius 5", judge(false, astray, hint),
               "start far from the hit or end early");
}

TEST_CASE("inside a hollow mirror all mirrored paths are equally long", "[lab4]") {
    // The chords of a sphere that meet it at one angle.
    const auto wrong = [](const Intersection& hit, const Ray& mirrored) {
        Intersection next;
        if (!ball.intersect(mirrored, next)) return true;
        const float before = (hit.position - hit.ray.orig).norm();
        return !(std::fabs((next.position - hit.position).norm() - before) < 0.01f);
    };
    expectNone("rays mirrored by a ball from inside", judge(true, wrong, rayHint),
               "take a path of another length");
}
