#include <cstdlib>

#include "swNff.h"
#include "tools/bench/parts.h"
#include "tools/common/scenes/scenes.h"

namespace bench {
namespace {

// Converts every number in the text and stores none: less work than any reader does.
double sumOfNumbers(const std::string& text) {
    double sum = 0;
    for (const char* at = text.c_str(); *at != '\0';) {
        char* end = nullptr;
        sum += static_cast<double>(std::strtof(at, &end));
        at = end == at ? at + 1 : end;
    }
    return sum;
}

}  // namespace

void measureLoading(const Setup& setup, Lines& lines) {
    const int size = setup.quick ? 6 : 10;
    const std::string text = scenes::mount(size);
    const double megabytes = static_cast<double>(text.size()) / 1e6;
    volatile double sum = 0;  // keeps the compiler from removing the work
    const Times times(setup.repetitions(3),
                      {[&] { return processorSecondsOf([&] { sw::parseNff(text, "mount"); }); },
                       [&] { return processorSecondsOf([&] { sum = sumOfNumbers(text); }); }});
    const std::string what = std::to_string(2 << 2 * size) + " triangles, reading their text";
    const double ours = megabytes / times.of(0), strtofs = megabytes / times.of(1);
    constexpr double goal = 60;
    lines.push_back({what, "strtof of its numbers", "MB/s", ours, strtofs, times.ratio(1, 0)});
    lines.push_back(
        {what, "the target", "MB/s", ours, goal, ours / goal, Target{Target::atLeast, 1}});
}

}  // namespace bench
