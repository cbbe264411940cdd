// The oracle computes the view's basis in exact arithmetic. Double precision loses 2^-52 of the
// cross product of view and up, whose length is the sine of the angle between them: from 2^-19 on
// the rays must agree to the rounding of their three floats. Closer to parallel the picture may be
// turned about the view, but must still be a picture: see the second test.

#include "stability/cases.h"
#include "stability/exact.h"
#include "swCamera.h"

using namespace sw;
using namespace test;
using exact::Real;
using exact::Real3;

namespace {

constexpr int width = 64, height = 48;

struct View {
    Vec3 from, at, up;
    float angle;

    Camera camera() const {
        Camera result(from, at, up, angle);
        result.setup(width, height);
        return result;
    }
    Real halfHeight() const { return std::tan(angle * (std::acos(-1.0) / 360)); }
};

View anyView(Random& random, double upAngle) {
    View view;
    const Vec3 forward = anyDirection(random), side = across(random, forward);
    const float distance = random.magnitude(1e-6, 1e6);
    view.from = random.coin() ? random.direction() * (distance * random.real(0, 10)) : Vec3();
    view.at = view.from + forward * distance;
    const Vec3 seen = view.at - view.from;
    const Vec3 along = seen * (random.coin() ? random.magnitude(1e-3, 1e3) : -1.0f);
    view.up = moved(along, side, upAngle * along.norm());
    view.angle = random.real(1, 170);
    return view;
}

std::string show(const View& v) {
    return describe("from", v.from, "at", v.at, "up", v.up, "angle", v.angle);
}

}  // namespace

TEST_CASE("camera rays are right where up is nearly parallel to the view") {
    int tried = 0;
    checkRandomCases(2 * familySize, [&](Random& random) {
        const View view = anyView(random, random.magnitude(1e-6, 10));
        const Real3 forward = exact::unit(Real3(view.at) - Real3(view.from));
        const Real3 across = cross(forward, exact::unit(Real3(view.up)));
        if (exact::length(across) < 0x1p-19) return std::string();
        ++tried;
        const Real3 right = exact::unit(across), up = cross(right, forward);
        const float x = random.real(0, width), y = random.real(0, height);
        const Real pixel = 2 * view.halfHeight() / height;
        const Real3 expected = exact::unit(forward + (x - Real(width) / 2) * pixel * right +
                                           (Real(height) / 2 - y) * pixel * up);
        const Ray ray = view.camera().getRay(x, y);
        const Real error = exact::length(Real3(ray.dir) - expected);
        if (error <= 2 * u) return std::string();
        return describe("off by", static_cast<double>(error) / u, "u at", x, y) + show(view);
    });
    CHECK(tried > familySize);
}

TEST_CASE("a camera whose up is parallel to the view makes a picture all the same") {
    checkRandomCases(familySize, [](Random& random) {
        View view = anyView(random, random.coin() ? 0 : random.magnitude(1e-12, 1e-5));
        if (random.whole(0, 9) == 0) view.up = Vec3(0, 0, 0);
        const Camera camera = view.camera();
        const Real3 forward = exact::unit(Real3(view.at) - Real3(view.from));
        const Real3 center(camera.getRay(width / 2, height / 2).dir);
        if (exact::length(center - forward) > 2 * u) return "centre" + show(view);
        // The corners: on a rectangle, right-handed, and as far from the centre as the angle says.
        const Real tangent = view.halfHeight();
        Real3 corner[4];
        for (int i = 0; i < 4; ++i) {
            const Ray ray = camera.getRay(i % 2 == 0 ? 0 : width, i < 2 ? 0 : height);
            const Real3 d(ray.dir);
            if (exact::abs(exact::length(d) - 1) > 2 * u) return "length" + show(view);
            const Real slope = exact::root(1 + Real(width * width) / (height * height)) * tangent;
            const Real cosine = 1 / exact::root(1 + slope * slope);
            if (exact::abs(dot(d, forward) - cosine) > 4 * u) return "angle" + show(view);
            corner[i] = (1 / cosine) * d;
        }
        const Real3 right = corner[1] - corner[0], down = corner[2] - corner[0];
        const Real area = dot(cross(right, down), forward), size = exact::length(right);
        const Real expected = 2 * tangent * width / height * 2 * tangent;
        if (exact::abs(area - expected) > 16 * u * (size + 1) * (size + 1))
            return "area" + show(view);
        return std::string();
    });
}
