#pragma once

#include "lab/lightAndFloor.h"
#include "lab/shadowHints.h"

namespace lab {

/// Fails the test unless light shows at all.
inline void requireLight() {
    Exposure best;
    if (findShowing(above, best)) return;
    const sw::Color open = Stage({}, {above}, {}).look(), dark = Stage({}, {}, {}).look();
    // With light and shadow exchanged every single ball between the two brings the light.
    bool exchanged = true;
    for (const float along : {1.5f, 3.f, 4.5f})
        exchanged &= !same(Stage({}, {above}, {thing(at(along))}).look(), dark);
    fail({"a floor under a light and nothing else", text(open) + ", as without the light",
          "another colour than without it",
          exchanged ? "lit and shadowed are exchanged: a light is passed over where nothing is in "
                      "the way, and counts where something is"
                    : ""});
}

/// Fails the test unless at least one of several balls between floor and light makes a difference:
/// else it might pass without any work done.
inline void requireShadows() {
    requireLight();
    const Shades shades = shadesOf(shown(), {above}, 0);
    bool nothingSent = true;
    std::string hint;
    for (const float along : {3.f, 0.75f, 5.f}) {
        const sw::Sphere ball = thing(at(along));
        Stage stage(shown(), {above}, {ball});
        if (!shades.isLit(stage.look())) return;
        nothingSent &= stage.furtherRays().empty();
        if (hint.empty()) hint = whyWrong(stage.furtherRays(), point, above.position, ball, false);
    }
    if (nothingSent)
        hint =
            "task 3 is not done yet: nothing asks whether something stands between surface and "
            "light";
    fail({"the floor's point " + text(point) + " under a light at " + text(above.position) +
              remark(shown()) + ", with balls in between",
          "the colour " + text(shades.lit) + ", as without them",
          text(shades.without) + ", as without that light", hint});
}

}  // namespace lab
