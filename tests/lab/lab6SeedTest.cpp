#include "lab/samplePlaces.h"

using namespace lab;
using namespace sw;

// The picture depends on its seed: on no thread, and on no pixel drawn before.

namespace {

constexpr int n = 3;

Pixel seeded(std::uint64_t seed, int x, int y) {
    seedPixel(seed, x, y);
    return pixelOf(skyScene(), x, y, n);
}

}  // namespace

TEST_CASE("a pixel's samples depend on its seed alone", "[lab6]") {
    for (int seed = 0; seed < 20; ++seed) {
        const auto number = static_cast<std::uint64_t>(seed);
        const Pixel pixel = seeded(number, 1, 2), neighbour = seeded(number, 2, 2);
        const Pixel other = seeded(number + 100, 1, 2), again = seeded(number, 1, 2);
        const std::string tried = "samplePixel() with n = 3 for pixel (1, 2), ";
        if (pixel.samples.size() < 2)
            fail({tried + "by itself", std::to_string(pixel.samples.size()) + " sample",
                  "9 samples", sampleHint()});
        if (!samePlaces(pixel, again))
            fail({tried + "twice with the same seed", "other samples the second time",
                  "the same samples",
                  "asked twice with the same seed the pixel came out differently: random numbers "
                  "of uniform() begin again with each pixel's seed"});
        if (samePlaces(pixel, other))
            fail({tried + "with two seeds", "samples at the same places for both",
                  "samples at other places", sampleHint()});
        if (samePlaces(pixel, neighbour))
            fail({tried + "and for pixel (2, 2)", "samples at the same places in both",
                  "samples at other places", sampleHint()});
    }
}
