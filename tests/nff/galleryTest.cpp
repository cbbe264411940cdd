#include "nff/shippedScenes.h"

using namespace sw;
using namespace test;

namespace {

Scene shipped(const std::string& name) {
    return loadNff(shippedFolder / (name + ".nff")).scene;
}

// Whether nothing stands between the two points, which may lie on surfaces.
bool sees(const Scene& scene, const Vec3& from, const Vec3& to) {
    Intersection none;
    return !scene.intersect(Ray(from, to - from, 0.001f, 0.999f), none, true);
}

// The point at an angle on a circle, clockwise from the top as seen from the front.
Vec3 onCircle(const Vec3& center, double radius, double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180;
    return center + Vec3(static_cast<float>(radius * std::sin(angle)),
                         static_cast<float>(radius * std::cos(angle)), 0);
}

// The same on the ground around the origin, as seen from below.
Vec3 onGround(double radius, double degrees) {
    const Vec3 p = onCircle({}, radius, degrees);
    return {p[0], 0, p[1]};
}

}  // namespace

TEST_CASE("the dull column has eight flat sides, each turned a sixteenth further") {
    const Scene scene = shipped("diffuse");
    const Vec3 middle(-2.9f, 0, 0);
    for (int side = 0; side < 8; ++side) {
        CAPTURE(side);
        const Vec3 normal = onGround(1, -90 + 22.5 * (side + 0.5));
        for (const float y : {0.2f, 1.8f, 3.4f}) {
            const Vec3 axis = middle + Vec3(0, y, 0);
            CHECK(distance(seen(scene, axis + normal * 2, axis).normal, normal) < 0.01);
        }
    }
}

TEST_CASE("the lantern's light leaves its ball and passes only between the posts") {
    const Scene scene = shipped("shadows");
    const Vec3 light = scene.lights()[0].position;
    for (int post = 0; post < 12; ++post) {
        CAPTURE(post);
        CHECK_FALSE(sees(scene, onGround(3, 30 * post), light));
        CHECK(sees(scene, onGround(3, 30 * post + 15), light));
    }
    const Intersection ball = seen(scene, Vec3(0, 7.5f, 10), light);
    CHECK(ball.hitT > 1);
    CHECK(sees(scene, ball.position, light));
}

TEST_CASE("the two mirrors reflect a ray back and forth") {
    const Scene scene = shipped("mirrors");
    Ray ray(Vec3(2, 6, 0), Vec3(0, 0, -1));
    for (int bounce = 0; bounce < 10; ++bounce) {
        Intersection hit;
        REQUIRE(scene.intersect(ray, hit));
        CHECK(distance(hit.position, Vec3(2, 6, bounce % 2 == 0 ? -10.0f : 10.0f)) <= 40 * u);
        ray = hit.getReflectedRay();
    }
}

TEST_CASE("the prism reflects totally: straight in, to the right, out, and onto the red ball") {
    const Scene scene = shipped("glass");
    const Vec3 ahead(0, 0, -1), right(1, 0, 0);
    const Vec3 directions[] = {ahead, right, right};  // after the front, the back and the side
    Ray ray(Vec3(1, 1, 10), ahead);
    for (const Vec3& next : directions) {
        Intersection hit;
        REQUIRE(scene.intersect(ray, hit));
        checkMaterial(hit.material, hit.material.color, 0.05f, 0.95f, 1.5f);
        CHECK(distance(hit.getRefractedRay().dir, next) <= 4 * u);
        const bool isMirrored = distance(hit.getReflectedRay().dir, next) <= 4 * u;
        CHECK(isMirrored == (distance(ray.dir, next) > 0.5));
        ray = hit.getRefractedRay();
    }
    Intersection ball;
    REQUIRE(scene.intersect(ray, ball));
    checkMaterial(ball.material, Color(0.9f, 0.12f, 0.08f), 0, 0, 1);
}

TEST_CASE("from under water one sees out through a round window, and around it the pool") {
    const Scene scene = shipped("water");
    const Vec3 eye(0, -2, 8);
    const double rim = 2 * std::tan(std::asin(1 / 1.33));
    for (int degrees = 0; degrees < 360; degrees += 15) {
        CAPTURE(degrees);
        for (const double factor : {0.99, 1.01}) {
            const Vec3 above = eye + Vec3(0, 2, 0) + onGround(factor * rim, degrees);
            const Intersection hit = seen(scene, eye, above);
            CHECK_FALSE(hit.frontFacing);
            CHECK((hit.getRefractedRay().dir[1] > 0) == (factor < 1));
        }
    }
}

TEST_CASE("trunks are upright, boughs lean, tips are points and the bucket is open") {
    const Scene scene = shipped("cones");
    const auto fromTheFront = [&](float x, float y, float z) {
        return seen(scene, Vec3(x, y, 20), Vec3(x, y, z));
    };
    CHECK(distance(fromTheFront(-1.9f, 0.5f, -1.2f).normal, Vec3(0, 0, 1)) <= 4 * u);
    CHECK(fromTheFront(-1.9f, 1.5f, -1.2f).normal[1] > 0.4f);
    CHECK(fromTheFront(-1.9f, 4.29f, -1.2f).material.color[1] > 0.3f);
    CHECK(sees(scene, Vec3(-1.9f, 4.31f, 20), Vec3(-1.9f, 4.31f, -20)));
    const Intersection snow = seen(scene, Vec3(0.4f, 3, 2.2f), Vec3(0.4f, 0, 2.2f));
    CHECK(snow.material.color[2] == 1);
    CHECK_FALSE(seen(scene, Vec3(0.4f, 3, 4.2f), Vec3(0.4f, 0.8f, 1.5f)).frontFacing);
}

TEST_CASE("the patches are where the flat triangles are, with the normals of a ball") {
    const Scene scene = shipped("patches");
    const Vec3 flat(-2.2f, 0, 0), smooth(2.2f, 0, 0);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 out = random.direction();
        CAPTURE(i, out);
        const Intersection a = seen(scene, flat, flat + out);
        const Intersection b = seen(scene, smooth, smooth + out);
        CHECK_FALSE((a.frontFacing || b.frontFacing));
        CHECK(std::fabs(a.hitT - b.hitT) <= 8 * u);
        CHECK(distance(b.geometricNormal, a.normal) <= 8 * u);
        // Each corner lies in the direction of its normal; so does then every point.
        CHECK(distance(-b.normal, out) <= 40 * u);
        CHECK(-a.normal * out > 0.79f);  // an icosahedron's inscribed to circumscribed radius
    }
}

TEST_CASE("the notches of star, gear and spiral are open") {
    const Scene scene = shipped("concave");
    const auto isCard = [&](const Vec3& point) {
        return seen(scene, point + Vec3(0, 0, 5), point).position[2] == 0;
    };
    for (int i = 0; i < 5; ++i) {
        CHECK(isCard(onCircle({-1.75f, 1.65f, 0}, 1.4, 72 * i)));
        CHECK_FALSE(isCard(onCircle({-1.75f, 1.65f, 0}, 0.9, 72 * i + 36)));
    }
    for (int i = 0; i < 10; ++i) {
        CHECK(isCard(onCircle({0, -1.75f, 0}, 1.5, 36 * i)));
        CHECK_FALSE(isCard(onCircle({0, -1.75f, 0}, 1.3, 36 * i + 18)));
        CHECK(isCard(onCircle({0, -1.75f, 0}, 1.1, 36 * i + 18)));
    }
    // From left to right through the middle: card and gaps in turn.
    for (const float x : {0.4f, 1.0f, 1.75f, 2.65f}) CHECK(isCard({x, 1.75f, 0}));
    for (const float x : {0.1f, 0.7f, 1.35f, 2.4f}) CHECK_FALSE(isCard({x, 1.75f, 0}));
}

TEST_CASE("the six lights add up to white, and each ball shadows a spot from each of them") {
    const Scene scene = shipped("lights");
    REQUIRE(scene.lights().size() == 6);
    Color sum(0, 0, 0);
    for (const Light& light : scene.lights()) {
        sum += light.color;
        const Vec3 down = Vec3(0, 1.4f, 0) - light.position;
        const Vec3 spot = light.position + down * (light.position[1] / -down[1]);
        CHECK_FALSE(sees(scene, spot, light.position));
        CHECK(sees(scene, Vec3(0, 0, 20), light.position));
    }
    CHECK(distance(sum, Color(1, 1, 1)) == 0);
}
