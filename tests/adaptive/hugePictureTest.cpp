// Where time is short for a huge picture, it goes into memory: none is taken that is not needed.
#include "support.h"
#include "swAdaptive.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

using namespace sw;
using namespace test;

namespace {

constexpr int side = 3000;

Color slope(float x, float y) {
    return Color(0.1f + 0.0002f * x, 0.1f + 0.0002f * y, 0.5f);
}

AdaptiveResult rendered(double seconds, bool details, int size) {
    AdaptiveOptions options;
    options.timeLimit = seconds;
    options.tolerance = 0.01f;
    options.details = details;
    options.render.threads = 2;
    return renderAdaptive({0, 0, size, size}, size, size, slope, options);
}

}  // namespace

TEST_CASE("without details, the picture and what is known of it as a whole are the same",
          "[adaptive]") {
    const double limit = GENERATE(1e-9, 1000.);
    const AdaptiveResult all = rendered(limit, true, 70), some = rendered(limit, false, 70);
    CHECK(some.sampleCounts.empty());
    CHECK((some.errors.width() == 1 && some.errors.height() == 1));
    CHECK((all.errors.width() == 70 && all.sampleCounts.size() == 70 * 70));
    CHECK(some.complete);
    CHECK((limit > 1 || all.samples < 100));
    if (all.samples != some.samples) return;  // a clock decides how many blocks are sampled
    CHECK(some.roughPixels == all.roughPixels);
    CHECK(some.estimatedRmse == all.estimatedRmse);
    int wrong = 0;
    for (int y = 0; y < 70; ++y)
        for (int x = 0; x < 70; ++x) wrong += !isSame(some.image.at(x, y), all.image.at(x, y));
    CHECK(wrong == 0);
}

#ifdef __linux__

namespace {

// Bytes of memory that a function gets from the system and touches, for each pixel.
template <typename Function>
double touchedBytes(const Function& function) {
    const auto faults = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_minflt;
    };
    const auto before = faults();
    function();
    return static_cast<double>(faults() - before) * static_cast<double>(sysconf(_SC_PAGESIZE)) /
           side / side;
}

}  // namespace

TEST_CASE("a new picture takes no memory until its pixels are set", "[adaptive]") {
    CHECK(touchedBytes([] {
              Image image(side, side);
              image.at(side / 2, side / 2) = Color(1, 1, 1);
          }) < sizeof(Color) / 2);  // a sanitizer takes a quarter of its own
}

TEST_CASE("a picture that there is no time for takes memory for its colours alone", "[adaptive]") {
    CHECK(touchedBytes([] { rendered(1e-9, false, side); }) < 1.5 * sizeof(Color));
}

#endif
