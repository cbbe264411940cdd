#include <map>
#include <mutex>

#include "support.h"
#include "swCorners.h"

using namespace sw;
using namespace test;

namespace {

// A colour that tells its place.
Color placeColor(int x, int y) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x * y)};
}

Image cornersOf(const Window& window, int threads) {
    return renderCorners(window, placeColor, {.threads = threads}).image;
}

}  // namespace

TEST_CASE("every corner is sampled once") {
    const Window window{3, 5, 3 + GENERATE(1, 16, 37), 5 + GENERATE(1, 15, 32)};
    std::map<std::pair<int, int>, int> asked;
    std::mutex mutex;
    renderCorners(window, [&](int x, int y) {
        const std::lock_guard lock(mutex);
        ++asked[{x, y}];
        return Color();
    });
    CHECK(asked.size() == static_cast<std::size_t>((window.width() + 1) * (window.height() + 1)));
    for (const auto& [place, times] : asked) {
        CHECK(times == 1);
        CHECK((place.first >= window.x0 && place.first <= window.x1));
        CHECK((place.second >= window.y0 && place.second <= window.y1));
    }
}

TEST_CASE("a pixel is the mean of its four corners") {
    const Window window{2, 1, 40, 30};
    const Image image = cornersOf(window, GENERATE(1, 2, 5));
    int wrong = 0;
    for (int y = window.y0; y < window.y1; ++y)
        for (int x = window.x0; x < window.x1; ++x) {
            const Color sum = placeColor(x, y) + placeColor(x + 1, y) + placeColor(x, y + 1) +
                              placeColor(x + 1, y + 1);
            wrong += distance(image.at(x - window.x0, y - window.y0), 0.25f * sum) != 0;
        }
    CHECK(wrong == 0);
}

TEST_CASE("options apply to corners as to pixels") {
    int calls = 0, tiles = 0;
    const RenderResult result = renderCorners(
        {0, 0, 40, 40}, placeColor, {.tileSize = 41, .threads = 3, .progress = [&](int, int total) {
                                         ++calls, tiles = total;
                                     }});
    CHECK((calls == 1 && tiles == 1));
    CHECK(result.threads == 1);
}

TEST_CASE("an exception from a corner is passed on") {
    CHECK_THROWS_AS(renderCorners({0, 0, 8, 8},
                                  [](int x, int) -> Color {
                                      if (x == 8) throw std::runtime_error("corner");
                                      return {};
                                  }),
                    std::runtime_error);
}
