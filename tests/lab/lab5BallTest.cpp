#include "lab/ballPicture.h"
#include "lab/bend.h"

using namespace lab;
using namespace sw;

// Rays through balls of glass.

namespace {

const Sphere ball(Vec3(3, -2, 7), 5, glass(1, 1.5f));

// A ray on its way through the ball.
struct Passage {
    Intersection entry, exit;
    Ray inside, out;
    bool meetsExit;
};

// Passages of 1000 random rays that do not just graze the ball.
std::vector<Passage> passages() {
    test::Random random(5);
    std::vector<Passage> all;
    while (all.size() < 1000) {
        const Vec3 from = ball.center + 20 * random.direction();
        const Vec3 towards = ball.center + ball.radius * random.direction();
        Passage p;
        const Ray ray(from, unit(towards - from));
        if (!ball.intersect(ray, p.entry) || ray.dir * p.entry.normal > -0.2f) continue;
        p.inside = p.entry.getRefractedRay();
        p.meetsExit = !isEmpty(p.inside) && ball.intersect(p.inside, p.exit);
        if (p.meetsExit) p.out = p.exit.getRefractedRay();
        all.push_back(p);
    }
    return all;
}

// Those of them that go wrong, as told by `wrong`.
template <typename Wrong, typename Hint>
Verdict judge(Wrong wrong, Hint hint) {
    Verdict verdict;
    for (const Passage& p : passages())
        if (wrong(p)) verdict.add(hint(p));
    return verdict;
}

// Why a refracted ray goes wrong: its direction, else its start.
std::string rayHint(const Intersection& hit, const Ray& got) {
    const Crossing x{unit(hit.ray.dir), hit.normal, 1.5f, hit.frontFacing};
    if (!agree(heading(got.dir), x.refracted())) return bendHint(got, x);
    return startHint(got, hit, -hit.normal, "refracted");
}

std::string entryHint(const Passage& p) {
    return rayHint(p.entry, p.inside);
}

// Of the way in if there is something wrong with it, else of the way out.
std::string passageHint(const Passage& p) {
    const std::string hint = entryHint(p);
    return hint.empty() && p.meetsExit ? rayHint(p.exit, p.out) : hint;
}

std::string outOfAThousand(const Verdict& verdict, const std::string& what) {
    return std::to_string(verdict.wrong()) + " of 1000 " + what;
}

// How far from the ball's centre a ray passes, or would pass.
float distanceFromCentre(const Ray& ray) {
    return ((ball.center - ray.orig) % unit(ray.dir)).norm();
}

}  // namespace

TEST_CASE("a refracted ray goes through the inside of a ball to its other side", "[lab5]") {
    const auto wrong = [](const Passage& p) {
        // Refracted light turns towards the centre, so its way through the ball is long.
        return !p.meetsExit || p.exit.frontFacing ||
               (p.exit.position - p.entry.position).norm() < 1;
    };
    const Verdict verdict = judge(wrong, entryHint);
    if (verdict.wrong() == 0) return;
    fail({"rays that are refracted into a ball of glass",
          outOfAThousand(verdict, "never reach the inside of its other side"), "none",
          verdict.hint()});
}

TEST_CASE("a refracted ray starts where the surface was hit", "[lab5]") {
    const auto wrong = [](const Passage& p) {
        return isEmpty(p.inside) || !alike(startOf(p.inside), p.entry.position, 0.05f) ||
               p.inside.maxT < 1e6f;
    };
    const auto hint = [](const Passage& p) {
        return isStarters(p.inside) ? refractionNotYet
                                    : startHint(p.inside, p.entry, -p.entry.normal, "refracted");
    };
    const Verdict verdict = judge(wrong, hint);
    if (verdict.wrong() == 0) return;
    fail({"rays that are refracted into a ball of glass of radius 5",
          outOfAThousand(verdict, verdict.hint() == refractionNotYet
                                      ? "are empty"
                                      : "start far from the hit or end early"),
          "none", verdict.hint()});
}

TEST_CASE("a ray that has left a ball of glass never hits it again", "[lab5]") {
    const auto wrong = [](const Passage& p) {
        Intersection again;
        return !p.meetsExit || isEmpty(p.out) || ball.intersect(p.out, again);
    };
    const Verdict verdict = judge(wrong, passageHint);
    if (verdict.wrong() == 0) return;
    fail({"rays that leave a ball of glass",
          outOfAThousand(verdict, "hit the ball again, or never come so far"), "none",
          verdict.hint()});
}

TEST_CASE("a ray passes a ball's centre as far away after it as before", "[lab5]") {
    // What bends it on the way in and on the way out is the same angle.
    float before = 0, after = 0;
    const auto wrong = [&](const Passage& p) {
        const float expected = distanceFromCentre(p.entry.ray);
        const float got = p.meetsExit && !isEmpty(p.out) ? distanceFromCentre(p.out) : -1;
        const bool isWrong = !(std::fabs(got - expected) < 0.01f);
        if (isWrong) before = expected, after = got;
        return isWrong;
    };
    const Verdict verdict = judge(wrong, passageHint);
    if (verdict.wrong() == 0) return;
    fail({"rays through a ball of glass of radius 5; one passes its centre at a distance of " +
              text(before) + " before it is refracted",
          after < 0 ? "it never comes out" : "a distance of " + text(after) + " behind the ball",
          "the same distance as before", verdict.hint()});
}

TEST_CASE("balls of glass before black balls: the picture", "[lab5]") {
    constexpr int mostRays = 20000;
    World world(mostRays);
    const auto add = [&](float x, float y, float z, float radius, const Material& material) {
        world.push(Sphere(Vec3(x, y, z), radius, material));
    };
    add(-10, 8, 0, 8, glass(0.95f, 1.5f));
    add(9, 9, 4, 7, glass(0.8f, 1.3f));
    add(8, -9, 0, 9, glass(0.9f, 1.1f));
    add(-10, -11, 4, 7, glass(1, 1.4f));
    add(-18, 13, -40, 5, opaque());
    add(-7, 4, -40, 3, opaque());
    add(14, 18, -25, 4, opaque());
    add(12, -4, -30, 3, opaque());
    add(4, -14, -15, 2.5f, opaque());
    add(-16, -17, -22, 4, opaque());
    add(-6, -7, -22, 2, opaque());
    add(20, 0, -10, 3, opaque());
    const Image image = pictureOf(refraction, world);
    const std::string fault = faultOfPicture(image), weights = weightHint(refraction);
    const BendSuspect* direction = bendCulprit();
    expectPicture("lab5-glass", image, 3, 20,
                  {"four balls of glass before eight black ones under the sky",
                   !fault.empty()         ? fault
                   : !weights.empty()     ? weights
                   : direction != nullptr ? direction->hint
                                          : ""});
}
