#include "lab/lightAndFloor.h"
#include "lab/requireShadows.h"
#include "lab/shadowHints.h"

using namespace lab;
using namespace sw;

namespace {

std::string about(const Sphere& ball, const Light& light) {
    return "the floor's point " + lab::text(point) + " under a light at " +
           lab::text(light.position) + ", with a ball of radius " + lab::text(ball.radius) +
           " at " + lab::text(ball.center);
}

enum class Expected { hidden, lit };

[[noreturn]] void failAt(const std::string& tried, const Color& got, Expected expected,
                         const Shades& shades, const std::string& hint,
                         const Exposure& exposure = shown()) {
    const std::string fault = newFault(got, shades);
    fail({tried + remark(exposure), "the colour " + lab::text(got),
          expected == Expected::hidden ? lab::text(shades.without) + ", as without that light"
                                       : lab::text(shades.lit) + ", as without the ball",
          fault.empty() ? hint : fault});
}

// A thing has to hide the light, or must not.
void expectShadow(Expected expected, const Sphere& ball, const Light& light = above) {
    const Exposure exposure = shown(light);
    const Shades shades = shadesOf(exposure, {light}, 0);
    Stage stage(exposure, {light}, {ball});
    const Color got = stage.look();
    const bool hide = expected == Expected::hidden;
    if (hide ? shades.isHidden(got) : shades.isLit(got)) return;
    const bool clear = hide ? shades.isLit(got) : shades.isHidden(got);
    const Asked rays = stage.furtherRays();
    std::string hint = clear ? whyWrong(rays, point, light.position, ball, !hide) : "";
    if (hide && wentOnFrom(ball, rays)) hint = hitOverwritten;
    failAt(about(ball, light), got, expected, shades, hint, exposure);
}

bool hides(const std::vector<Sphere>& balls) {
    return shadesOf(shown(), {above}, 0).isHidden(Stage(shown(), {above}, balls).look());
}

}  // namespace

TEST_CASE("what stands between a surface and a light hides it", "[lab3]") {
    requireShadows();
    for (const float along : {0.75f, 1.5f, 3.f, 4.5f, 5.25f, 6.f})
        expectShadow(Expected::hidden, thing(at(along)));
    expectShadow(Expected::hidden, thing(at(0.3f), 0.1f));
}

TEST_CASE("what stands beyond a light casts no shadow", "[lab3]") {
    requireShadows();
    for (const float along : {6.75f, 8.f, 12.f, 40.f})
        expectShadow(Expected::lit, thing(at(along)));
}

TEST_CASE("a room around everything casts no shadow", "[lab3]") {
    requireShadows();
    const Sphere room(point, 50, matte({1, 1, 1}));
    const Shades shades = shadesOf(shown(), {above}, 0);
    Stage stage(shown(), {above}, {room});
    const Color got = stage.look();
    if (shades.isLit(got)) return;
    // Where the ray leaves the room, on its way through the light, is what hides it.
    const Sphere wall = thing(at(50));
    failAt("the floor under a light, inside a ball of radius 50 that holds them both", got,
           Expected::lit, shades,
           shades.isHidden(got) ? whyWrong(stage.furtherRays(), point, above.position, wall, true)
                                : "");
}

TEST_CASE("what stands beside the way to a light casts no shadow", "[lab3]") {
    requireShadows();
    for (const Vec3& centre : {at(3, 1), at(5, 0, 0.75f), at(1, 3), at(2, 0, -2), at(3, -1)})
        expectShadow(Expected::lit, thing(centre));
}

TEST_CASE("what stands behind the surface casts no shadow", "[lab3]") {
    requireShadows();
    for (const float along : {-3.f, -0.75f, -6.f}) expectShadow(Expected::lit, thing(at(along)));
}

TEST_CASE("a shadow moves with its light", "[lab3]") {
    requireShadows();
    const Light other(at(4, 4, 1));
    expectShadow(Expected::hidden, thing(at(2, 2, 0.5f)), other);
    expectShadow(Expected::lit, thing(at(3)), other);
    expectShadow(Expected::lit, thing(at(2, 2, 0.5f)), above);
}

TEST_CASE("glass and mirrors cast shadows like anything else", "[lab3]") {
    requireShadows();
    const bool matt = hides({thing(at(3))});
    for (const Material& material :
         {Material({1, 1, 1}, 0.2f, 0.8f, 1.3f), Material({1, 1, 1}, 1)}) {
        const Sphere ball(at(3), 0.5f, material);
        const Shades shades = shadesOf(shown(), {above}, 0);
        Stage stage(shown(), {above}, {ball});
        const Color got = stage.look();
        if (shades.isHidden(got)) continue;
        std::string hint;
        if (wentOnFrom(ball, stage.furtherRays()))
            hint = hitOverwritten;
        else if (matt)
            hint =
                "the shadow of this lab asks whether something stands in the way, not of what "
                "it is made";
        else if (shades.isLit(got))
            hint = whyWrong(stage.furtherRays(), point, above.position, ball, false);
        failAt("a floor under a light, with a ball of glass or a mirror ball between them", got,
               Expected::hidden, shades, hint);
    }
}

// A search for any hit may find the farther one first: here the one that was pushed first.
TEST_CASE("what stands beyond a light does not keep a shadow from falling", "[lab3]") {
    requireShadows();
    const Sphere between = thing(at(3)), beyond = thing(at(12));
    const bool nearFirst = hides({between, beyond}), farFirst = hides({beyond, between});
    if (nearFirst && farFirst) return;
    fail({"the floor's point " + lab::text(point) + " under a light at " +
              lab::text(above.position) + remark(shown()) +
              ", with one ball between them and one beyond the light",
          "the light is not hidden", "a shadow, as the first ball casts it alone",
          nearFirst && hides({between}) && !hides({beyond})
              ? "a search for any hit may find one beyond the light, though another one lies "
                "between: it need not be the nearest"
              : ""});
}

TEST_CASE("each light has its own shadow", "[lab3]") {
    requireShadows();
    const Light red(at(6), {1, 0, 0}), green(at(2, 5, 3), {0, 1, 0});
    const auto expectOthers = [](const std::vector<Light>& lights, std::size_t hidden) {
        const Sphere ball = thing(point + (lights[hidden].position - point) * 0.5f);
        const Shades shades = shadesOf(shown(), lights, hidden);
        Stage stage(shown(), lights, {ball});
        const Color got = stage.look();
        if (shades.isHidden(got)) return;
        const Color dark = Stage(shown(), {}, {}).look();
        std::string hint;
        if (wentOnFrom(ball, stage.furtherRays()))
            hint = hitOverwritten;
        else if (same(got, dark))
            // The second is asked about only where the first one's shadow did no harm.
            hint = hidden == 0 ? "the shadow of one light darkens the other as well: in shadow of "
                                 "one, go on with the next"
                               : "the shadow of one light takes away what another one has brought "
                                 "already: it is to pass over its own light and nothing else";
        else if (shades.isLit(got) && stage.furtherRays().size() == 1)
            hint = "every light needs a shadow ray of its own";
        failAt("a floor under two lights, the " + std::string(hidden == 0 ? "first" : "second") +
                   " of them in shadow",
               got, Expected::hidden, shades, hint);
    };
    for (const auto& lights : {std::vector{red, green}, std::vector{green, red}})
        for (const std::size_t hidden : {0u, 1u}) expectOthers(lights, hidden);
}

TEST_CASE("there are shadows at every depth of recursion", "[lab3]") {
    requireShadows();
    const Shades usual = shadesOf(shown(), {above}, 0);
    for (const int depth : {0, 1, 2, 5}) {
        const Shades shades = shadesOf(shown(), {above}, 0, depth);
        // Such a colour is none that shading gives, but belongs to task 4.
        if (!same(shades.lit, usual.lit)) continue;
        Stage stage(shown(), {above}, {thing(at(3))});
        const Color got = stage.look(depth);
        if (shades.isHidden(got)) continue;
        std::string hint;
        if (shades.isLit(got))
            hint = hides({thing(at(3))})
                       ? "depth limits reflected and refracted rays alone: a shadow ray is needed "
                         "at every depth"
                       : whyWrong(stage.furtherRays(), point, above.position, thing(at(3)), false);
        failAt("a ball between floor and light, seen by traceRay() with depth " +
                   std::to_string(depth),
               got, Expected::hidden, shades, hint);
    }
}
