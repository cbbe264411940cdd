#include "app/progressBar.h"

#include "files.h"
#include "support.h"

using namespace test;

namespace {

Progress anyProgress(Random& random) {
    const auto maybe = [&random](double value) {
        return random.whole(0, 1) == 0 ? std::optional<double>() : value;
    };
    Progress progress;
    progress.seconds = random.magnitude(1e-3, 1e9);
    progress.done = maybe(random.real(-0.5, 1.5));
    progress.secondsLeft = maybe(random.magnitude(1e-3, 1e9));
    progress.pass = random.whole(0, 60);
    progress.passDone = random.real(-0.5, 1.5);
    progress.error = maybe(random.magnitude(1e-9, 1));
    progress.targetError = random.whole(0, 1) == 1 ? random.magnitude(1e-9, 1) : 0;
    if (random.whole(0, 1) == 1) progress.slowPixel = {random.whole(0, 16383), 16383};
    return progress;
}

}  // namespace

TEST_CASE("the progress line never wraps") {
    Random random(GENERATE(range(0u, 100u)));
    const Progress progress = anyProgress(random);
    for (int width = 0; width <= 200; ++width) {
        const std::string line = progressLine(progress, width);
        CAPTURE(width, line);
        CHECK(static_cast<int>(line.size()) <= std::max(width - 1, 0));
        CHECK(line.find_first_of("\r\n\x1b") == std::string::npos);
    }
}

TEST_CASE("the progress line says what is known, and nothing else") {
    Progress plain;
    plain.done = 0.625;
    plain.secondsLeft = 12.34;
    CHECK(progressLine(plain, 80) ==
          "[" + std::string(25, '#') + std::string(15, ' ') + "]  62 %  12.3 s left");
    CHECK(progressLine(plain, 30) == "[#####   ]  62 %  12.3 s left");
    CHECK(progressLine(plain, 12) == " 62 %  12.3");

    Progress adaptive;
    adaptive.seconds = 7.06;
    adaptive.pass = 3;
    adaptive.passDone = 0.5;
    adaptive.error = 0.0123;
    adaptive.targetError = 0.001;
    CAPTURE(progressLine(adaptive, 100));
    CHECK(has(progressLine(adaptive, 100), "] 7.1 s  pass 3, 50 %  rmse 0.012 -> 0.001"));
    CHECK_FALSE(has(progressLine(adaptive, 100), "left"));
    adaptive.slowPixel = {130, 240};
    CHECK(has(progressLine(adaptive, 100), "at pixel 130,240"));
}
