#include <cmath>
#include <memory>
#include <vector>

#include "lab/matte.h"
#include "lab/teach.h"
#include "tools/common/mainFunctions.h"

using namespace sw;

namespace {

constexpr const char* notDone =
    "task 1 is not done yet: every surface is still as white as the starter paints it";
constexpr const char* notNormalised =
    "the result grows with the distance of the light: a dot product is a cosine only where both "
    "vectors have length 1";
constexpr const char* fallsOff = "the lights of this lab do not get weaker with distance";
constexpr const char* negative =
    "a cosine below zero means that the light stands behind the surface: it gives nothing then, "
    "but "
    "takes nothing away either";
constexpr const char* wrongWay =
    "the sign is turned round: the way that counts goes from the surface to the light";
constexpr const char* bothSides =
    "the sign of the cosine tells front from back; without it, lights shine through the surface";
constexpr const char* fromTheEye =
    "what counts is the angle between the normal and the way to the light; a matt surface looks "
    "the "
    "same from everywhere";
constexpr const char* positionAsDirection =
    "the place of the light is no direction yet: where does the way to it begin?";
constexpr const char* noPaint = "the material has a colour, and the surface returns only that part";
constexpr const char* noTint = "the light has a colour too, and the surface can return no other";
constexpr const char* lastOnly =
    "only the last light is seen: what the others gave has to be kept and added to";
constexpr const char* firstOnly = "only the first light is seen: are the others still asked?";
constexpr const char* general =
    "three things decide: the colour of the material, that of the light, and Lambert's cosine of "
    "the angle between the normal and the way to the light";

const Color paint(0.5f, 0.25f, 0.75f);
const Vec3 place(-3, 8, 1);   // of the surface, which faces upwards
const Vec3 aside(-5, 0, 12);  // from there to the eye, 13 long: cosine 12/13
const float eyeCosine = 12.f / 13;

// A bit of surface that is seen from one eye and that no other ray can meet. So nothing casts a
// shadow, whatever becomes of task 3.
class Spot : public Primitive {
public:
    Spot(const Vec3& where, const Vec3& seenFrom, const Color& color)
        : Primitive(lab::matte(color)), position(where), eye(seenFrom) {}

    bool intersect(const Ray& ray, Intersection& hit) const override {
        if (!(ray.orig - eye).isZero()) return false;
        hit.hitT = (position - eye).norm();
        hit.position = position;
        hit.normal = Vec3(0, 0, 1);
        hit.frontFacing = true;
        hit.material = material;
        hit.ray = ray;
        return ray.minT < hit.hitT && hit.hitT < ray.maxT;
    }

private:
    Vec3 position, eye;
};

struct Shown {
    Vec3 where = place;
    Vec3 eye = place + aside;
    Color color = paint;
};

Color look(const Shown& shown, const std::vector<Light>& lights) {
    Scene scene;
    scene.push(std::make_shared<Spot>(shown.where, shown.eye, shown.color));
    for (const Light& light : lights) scene.push(light);
    Vec3 along = shown.where - shown.eye;
    return lab::traceRay(Ray(shown.eye, along.normalize()), scene, 0);
}

bool same(const Color& a, const Color& b) {
    for (int i = 0; i < 3; ++i)
        if (!(std::fabs(a[i] - b[i]) <= 1e-4f * (1 + std::fabs(b[i])))) return false;
    return true;
}

// What a mistake would make of the colour.
struct Mistake {
    Color gives;
    const char* hint;
};

// For a colour that no mistake explains.
const char* whyElse() {
    const Vec3 toLight(3, 0, 4), origin(0, 0, 0);
    const Color here = look({}, {Light(place + toLight)});
    return same(here, look({origin, aside, paint}, {Light(toLight)})) ? general
                                                                      : positionAsDirection;
}

void expectColor(const std::string& tried, const Color& got, const Color& expected, int lights,
                 const std::vector<Mistake>& mistakes) {
    if (same(got, expected)) return;
    const char* hint = same(got, Color(1, 1, 1) * lights) ? notDone : nullptr;
    for (const Mistake& mistake : mistakes)
        if (!hint && same(got, mistake.gives)) hint = mistake.hint;
    lab::fail(
        {tried, "the colour " + lab::text(got), lab::text(expected), hint ? hint : whyElse()});
}

std::string lightAt(const Vec3& fromSurface) {
    return "a surface that faces +z, with a white light at " + lab::text(fromSurface) + " from it";
}

}  // namespace

TEST_CASE("a surface is lit by the cosine of the angle to the light", "[lab1]") {
    struct Case {
        Vec3 light;
        float length, cosine;
    };
    for (const Case& c :
         {Case{{0, 0, 2}, 2, 1}, Case{{3, 0, 4}, 5, 0.8f}, Case{{0, -4, 3}, 5, 0.6f},
          Case{{1, 2, 2}, 3, 2 / 3.f}, Case{{12, 0, 5}, 13, 5 / 13.f}, Case{{-24, 0, 7}, 25, 0.28f},
          Case{{0, 60, 11}, 61, 11 / 61.f}})
        expectColor(lightAt(c.light), look({}, {Light(place + c.light)}), paint * c.cosine, 1,
                    {{paint * c.light[2], notNormalised},
                     {paint * -c.cosine, wrongWay},
                     {Color(0, 0, 0), wrongWay},
                     {paint * eyeCosine, fromTheEye},
                     {Color(1, 1, 1) * c.cosine, noPaint}});
}

TEST_CASE("a light behind the surface gives nothing", "[lab1]") {
    struct Case {
        Vec3 light;
        float cosine;
    };
    for (const Case& c : {Case{{3, 0, -4}, 0.8f}, Case{{0, 0, -2}, 1}, Case{{24, 0, -7}, 0.28f}})
        expectColor(lightAt(c.light), look({}, {Light(place + c.light)}), Color(0, 0, 0), 1,
                    {{paint * -c.cosine, negative},
                     {paint * c.light[2], negative},
                     {paint * c.cosine, bothSides},
                     {paint * eyeCosine, fromTheEye}});
}

TEST_CASE("a light behind the surface takes nothing from the light in front", "[lab1]") {
    const Light front(place + Vec3(3, 0, 4)), behind(place + Vec3(4, 0, -3));
    for (const auto& lights : {std::vector{front, behind}, std::vector{behind, front}})
        expectColor(
            "a surface between two white lights, its normal at cosine 0.8 to one and -0.6 "
            "to the other",
            look({}, lights), paint * 0.8f, 2,
            {{paint * 0.2f, negative},
             {paint * 1, negative},
             {paint * 1.4f, bothSides},
             {paint * (2 * eyeCosine), fromTheEye},
             {Color(0, 0, 0), lastOnly}});
}

TEST_CASE("a light far away is as bright as one nearby", "[lab1]") {
    for (const float times : {1.f, 0.125f, 2.f, 64.f, 1024.f}) {
        const Vec3 light = Vec3(3, 0, 4) * times;
        expectColor(lightAt(light), look({}, {Light(place + light)}), paint * 0.8f, 1,
                    {{paint * (4 * times), notNormalised},
                     {paint * (0.8f / (5 * times)), fallsOff},
                     {paint * (0.8f / (25 * times * times)), fallsOff},
                     {paint * eyeCosine, fromTheEye}});
    }
}

TEST_CASE("a matt surface looks the same from everywhere", "[lab1]") {
    for (const Vec3& toEye : {Vec3(0, 0, 5), Vec3(-5, 0, 12), Vec3(24, 0, 7)}) {
        const float seen = toEye[2] / toEye.norm();
        expectColor("a surface that faces +z, a light at (3, 0, 4) and the eye at " +
                        lab::text(toEye) + " from it",
                    look({place, place + toEye, paint}, {Light(place + Vec3(3, 0, 4))}),
                    paint * 0.8f, 1,
                    {{paint * seen, fromTheEye},
                     {paint * -seen, fromTheEye},
                     {Color(0, 0, 0), fromTheEye}});
    }
}

TEST_CASE("moving surface, light and eye together changes nothing", "[lab1]") {
    struct Case {
        Vec3 where;
        float cosineFromOrigin;  // of the light's place, taken for a direction
    };
    for (const Case& c :
         {Case{{-3, 8, 1}, 0.529999f}, Case{{-3, 0, 0}, 1}, Case{{6, 12, 0}, 0.264906f}})
        expectColor("a surface that faces +z at " + lab::text(c.where) + ", a white light at " +
                        lab::text(c.where + Vec3(3, 0, 4)),
                    look({c.where, c.where + aside, paint}, {Light(c.where + Vec3(3, 0, 4))}),
                    paint * 0.8f, 1,
                    {{paint * c.cosineFromOrigin, positionAsDirection},
                     {paint * 4, notNormalised},
                     {paint * eyeCosine, fromTheEye}});
}

TEST_CASE("a surface answers in its own colour", "[lab1]") {
    for (const Color& color : {Color(1, 0, 0), Color(0, 0.5f, 1), Color(0.25f, 0.75f, 0.5f)})
        expectColor(
            "a surface of colour " + lab::text(color) + " under a white light at a cosine of 0.8",
            look({place, place + aside, color}, {Light(place + Vec3(3, 0, 4))}), color * 0.8f, 1,
            {{Color(0.8f, 0.8f, 0.8f), noPaint},
             {color * 4, notNormalised},
             {color * eyeCosine, fromTheEye}});
}

TEST_CASE("a coloured light tints what it shines on", "[lab1]") {
    struct Case {
        Color tint, expected;
    };
    for (const Case& c : {Case{{1, 0, 0}, {0.4f, 0, 0}}, Case{{0.5f, 1, 2}, {0.2f, 0.2f, 1.2f}},
                          Case{{0, 0.5f, 0}, {0, 0.1f, 0}}})
        expectColor("a surface of colour " + lab::text(paint) + " under a light of colour " +
                        lab::text(c.tint) + " at a cosine of 0.8",
                    look({}, {Light(place + Vec3(3, 0, 4), c.tint)}), c.expected, 1,
                    {{paint * 0.8f, noTint},
                     {c.tint * 0.8f, noPaint},
                     {Color(0.8f, 0.8f, 0.8f), noPaint},
                     {c.expected * 5, notNormalised},
                     {c.expected * (eyeCosine / 0.8f), fromTheEye}});
}

TEST_CASE("several lights add up", "[lab1]") {
    const Light red(place + Vec3(3, 0, 4), Color(1, 0, 0));
    const Light green(place + Vec3(0, 4, 3), Color(0, 0.5f, 0));
    const Light blue(place + Vec3(-24, 0, 7), Color(0, 0, 1));
    const Color brought[] = {{0.4f, 0, 0}, {0, 0.075f, 0}, {0, 0, 0.21f}};
    expectColor("a surface of colour " + lab::text(paint) +
                    " under a red, a green and a blue light, from different directions",
                look({}, {red, green, blue}), Color(0.4f, 0.075f, 0.21f), 3,
                {{brought[2], lastOnly},
                 {brought[0], firstOnly},
                 {paint * (0.8f + 0.6f + 0.28f), noTint},
                 {Color(0.8f, 0.3f, 0.28f), noPaint},
                 {Color(2, 0.375f, 5.25f), notNormalised},
                 {Color(0.5f, 0.125f, 0.75f) * eyeCosine, fromTheEye}});
}
