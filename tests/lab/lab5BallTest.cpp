#include "lab/bend.h"
#include "lab/photo.h"

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

// How many of them go wrong, as told by `wrong`.
template <typename Wrong>
int countWrong(Wrong wrong) {
    int sum = 0;
    for (const Passage& p : passages()) sum += wrong(p);
    return sum;
}

std::string outOfAThousand(int count, const std::string& what) {
    return std::to_string(count) + " of 1000 " + what;
}

// How far from the ball's centre a ray passes, or would pass.
float distanceFromCentre(const Ray& ray) {
    return ((ball.center - ray.orig) % unit(ray.dir)).norm();
}

bool nothingDone() {
    return isEmpty(passages().front().inside);
}

}  // namespace

TEST_CASE("a refracted ray goes through the inside of a ball to its other side", "[lab5]") {
    const int wrong = countWrong([](const Passage& p) {
        // Refracted light turns towards the centre, so its way through the ball is long.
        return !p.meetsExit || p.exit.frontFacing ||
               (p.exit.position - p.entry.position).norm() < 1;
    });
    if (wrong == 0) return;
    fail({"rays that are refracted into a ball of glass",
          outOfAThousand(wrong, "never reach the inside of its other side"), "none",
          nothingDone() ? refractionNotYet
                        : "a refracted ray goes on behind the surface, and has to start a little "
                          "way behind it, or else it meets the same place again"});
}

TEST_CASE("a ray that has left a ball of glass never hits it again", "[lab5]") {
    const int wrong = countWrong([](const Passage& p) {
        Intersection again;
        return !p.meetsExit || isEmpty(p.out) || ball.intersect(p.out, again);
    });
    if (wrong == 0) return;
    fail({"rays that leave a ball of glass",
          outOfAThousand(wrong, "hit the ball again, or never come so far"), "none",
          nothingDone() ? refractionNotYet
                        : "on the way out, too, a refracted ray starts on the side that it goes "
                          "to: away from the normal, which is on the side that it came from"});
}

TEST_CASE("a ray passes a ball's centre as far away after it as before", "[lab5]") {
    // What bends it on the way in and on the way out is the same angle.
    float before = 0, after = 0;
    const int wrong = countWrong([&](const Passage& p) {
        const float expected = distanceFromCentre(p.entry.ray);
        const float got = p.meetsExit && !isEmpty(p.out) ? distanceFromCentre(p.out) : -1;
        const bool isWrong = !(std::fabs(got - expected) < 0.01f);
        if (isWrong) before = expected, after = got;
        return isWrong;
    });
    if (wrong == 0) return;
    fail({"rays through a ball of glass of radius 5; one passes its centre at a distance of " +
              text(before) + " before it is refracted",
          after < 0 ? "it never comes out" : "a distance of " + text(after) + " behind the ball",
          "the same distance as before",
          nothingDone() ? refractionNotYet
                        : "a ball bends a ray by the same angle on both of its sides: compare the "
                          "way in, where frontFacing is true, with the way out"});
}

TEST_CASE("balls of glass before black balls: the picture", "[lab5]") {
    World world;
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
    const Image image = photo(Camera(Vec3(0, 0, 70), Vec3(0, 0, 0), Vec3(0, 1, 0), 40),
                              [&](const Ray& ray) { return world.colorOf(ray, 6); });
    expectPicture("lab5-glass", image, 3, 20,
                  {"four balls of glass before eight black ones under the sky",
                   "dense balls show what is behind them upside down: if the other tests of this "
                   "task pass, look at how the depth is handed on"});
}
