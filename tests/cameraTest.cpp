#include "swCamera.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include "support.h"

using namespace sw;
using namespace test;

namespace {

struct View {
    Vec3 eye, lookAt, up;
    float fov;
    int width, height;

    Camera camera() const {
        Camera made(eye, lookAt, up, fov);
        made.setup(width, height);
        return made;
    }
};

View randomView(Random& random) {
    const Vec3 eye = random.point(50), view = random.direction();
    Vec3 up = random.direction();
    while (std::fabs(up * view) > 0.99) up = random.direction();
    return {eye,
            eye + view * random.magnitude(1, 100),
            up * random.magnitude(0.01, 100),
            random.real(10, 120),
            random.whole(1, 1000),
            random.whole(1, 1000)};
}

// At the origin, looking along -z.
Camera plainCamera(float fov, int width, int height) {
    Camera camera({0, 0, 0}, {0, 0, -3}, {0, 2, 0}, fov);
    camera.setup(width, height);
    return camera;
}

// Where GLM's projection puts the ray, in pixels.
glm::dvec2 project(const View& view, const Ray& ray) {
    const double aspect = static_cast<double>(view.width) / view.height;
    const double fov = glm::radians(static_cast<double>(view.fov));
    const dvec3 eye = toDouble(view.eye);
    const glm::dmat4 matrix = glm::perspective(fov, aspect, 0.5, 2.0) *
                              glm::lookAt(eye, toDouble(view.lookAt), toDouble(view.up));
    const glm::dvec4 p = matrix * glm::dvec4(eye + toDouble(ray.dir), 1);
    if (!(p.w > 0)) return {NAN, NAN};  // behind the camera
    return {(p.x / p.w + 1) / 2 * view.width, (1 - p.y / p.w) / 2 * view.height};
}

// Where the ray meets the plane at distance 1 in front of a plainCamera.
glm::dvec2 onPlane(const Ray& ray) {
    const dvec3 d = toDouble(ray.dir);
    return {d.x / -d.z, d.y / -d.z};
}

}  // namespace

TEST_CASE("each pixel position gets the ray that GLM projects back onto it") {
    const auto seed = GENERATE(range(0u, 1000u));
    CAPTURE(seed);
    Random random(seed);
    const View view = randomView(random);
    CAPTURE(view.width, view.height, view.fov);
    const float x = random.real(0, view.width), y = random.real(0, view.height);
    const glm::dvec2 pixel = project(view, view.camera().getRay(x, y));
    CHECK(std::fabs(pixel.x - x) <= 0.01);
    CHECK(std::fabs(pixel.y - y) <= 0.01);
}

TEST_CASE("the camera makes unit primary rays that start at the eye") {
    const auto seed = GENERATE(range(0u, 500u));
    CAPTURE(seed);
    Random random(seed);
    const View view = randomView(random);
    const float x = random.real(0, view.width), y = random.real(0, view.height);
    const Ray ray = view.camera().getRay(x, y);
    CHECK(std::fabs(glm::length(toDouble(ray.dir)) - 1) <= 1e-6);
    CHECK(distance(ray.orig, view.eye) == 0);
    CHECK(ray.minT == 0);
    CHECK(ray.maxT == FLT_MAX);
    CHECK(ray.kind == RayKind::primary);
}

TEST_CASE("the middle of the picture shows what the camera looks at") {
    const auto seed = GENERATE(range(0u, 200u));
    CAPTURE(seed);
    Random random(seed);
    const View view = randomView(random);
    const Ray ray = view.camera().getRay(static_cast<float>(view.width) / 2,
                                         static_cast<float>(view.height) / 2);
    const dvec3 forward = glm::normalize(toDouble(view.lookAt) - toDouble(view.eye));
    CHECK(distance(ray.dir, forward) <= 1e-6);
}

TEST_CASE("the field of view is vertical and the corners follow from the aspect") {
    const auto [width, height] =
        GENERATE(table<int, int>({{300, 300}, {600, 300}, {300, 600}, {2, 1}, {1, 2}}));
    const float fov = GENERATE(20.0f, 52.0f, 90.0f, 150.0f);
    CAPTURE(width, height, fov);
    const Camera camera = plainCamera(fov, width, height);
    const double up = std::tan(glm::radians(static_cast<double>(fov)) / 2);
    const double aside = up * width / height;
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    const auto looksTo = [&](float x, float y, double right, double upwards) {
        CAPTURE(x, y);
        const Ray ray = camera.getRay(x, y);
        CHECK(distance(ray.dir, glm::normalize(dvec3(right, upwards, -1))) <= 1e-6);
    };
    looksTo(0, 0, -aside, up);
    looksTo(w, 0, aside, up);
    looksTo(0, h, -aside, -up);
    looksTo(w, h, aside, -up);
    looksTo(w / 2, 0, 0, up);
    looksTo(w, h / 2, aside, 0);
}

TEST_CASE("pixel centres lie at one half and x grows to the right and y downwards") {
    const Camera camera = plainCamera(90, 4, 4);
    CHECK(distance(camera.getRay(2.5f, 1.5f).dir, glm::normalize(dvec3(0.25, 0.25, -1))) <= 1e-6);
    CHECK(distance(camera.getRay(3.5f, 3.5f).dir, glm::normalize(dvec3(0.75, -0.75, -1))) <= 1e-6);
    // A single pixel has its centre on the line of view.
    CHECK(distance(plainCamera(90, 1, 1).getRay(0.5f, 0.5f).dir, Vec3(0, 0, -1)) <= 1e-6);
}

TEST_CASE("pixels are square in pictures of any shape") {
    const auto [width, height] =
        GENERATE(table<int, int>({{512, 512}, {640, 320}, {320, 640}, {1000, 10}, {7, 900}}));
    CAPTURE(width, height);
    const Camera camera = plainCamera(52, width, height);
    const float x = static_cast<float>(width) / 2, y = static_cast<float>(height) / 2;
    const glm::dvec2 middle = onPlane(camera.getRay(x, y));
    const glm::dvec2 right = onPlane(camera.getRay(x + 3, y)) - middle;
    const glm::dvec2 down = onPlane(camera.getRay(x, y + 3)) - middle;
    const double expected = 6 * std::tan(glm::radians(26.0)) / height;
    CHECK(std::fabs(right.x / expected - 1) <= 1e-4);
    CHECK(std::fabs(down.y / -expected - 1) <= 1e-4);
    CHECK(std::fabs(right.y) <= 1e-4 * expected);
    CHECK(std::fabs(down.x) <= 1e-4 * expected);
}

TEST_CASE("the picture's size replaces the aspect that the camera was made with") {
    Camera wide({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 52, 2);
    wide.setup(30, 40);
    const Camera plain = plainCamera(52, 30, 40);
    for (const float x : {0.0f, 11.5f, 30.0f})
        CHECK(distance(wide.getRay(x, 7).dir, plain.getRay(x, 7).dir) <= 1e-6);
}

TEST_CASE("the camera can be set up again for another size") {
    Camera camera = plainCamera(52, 1000, 10);
    camera.setup(30, 40);
    CHECK(distance(camera.getRay(3, 7).dir, plainCamera(52, 30, 40).getRay(3, 7).dir) == 0);
}

TEST_CASE("an unusable up vector still gives an upright frame") {
    const auto seed = GENERATE(range(0u, 100u));
    CAPTURE(seed);
    Random random(seed);
    const Vec3 view = GENERATE(Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(0, 0, -1),
                               Vec3(1, 1, 1), Vec3(0, 0, 0)) +
                      random.point(1e-9);
    const float scale = GENERATE(1.0f, -7.0f, 0.0f);
    CAPTURE(view, scale);
    Camera camera({0, 0, 0}, view, view * scale, 90);
    camera.setup(2, 2);
    const dvec3 forward = toDouble(camera.getRay(1, 1).dir);
    // At 90 degrees, the frame's vectors are as long as the view is deep.
    const auto aside = [&](float x, float y) {
        const dvec3 d = toDouble(camera.getRay(x, y).dir);
        return d / dot(d, forward) - forward;
    };
    const dvec3 right = aside(2, 1), up = aside(1, 0);
    CHECK(std::fabs(glm::length(forward) - 1) <= 1e-6);
    CHECK(std::fabs(glm::length(right) - 1) <= 1e-5);
    CHECK(std::fabs(glm::length(up) - 1) <= 1e-5);
    CHECK(glm::length(cross(right, up) + forward) <= 1e-5);  // right-handed and at right angles
}
