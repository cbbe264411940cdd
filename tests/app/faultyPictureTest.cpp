#include "app/pixelFaults.h"
#include "app/programRun.h"
#include "support.h"

using namespace test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

sw::Image grey() {
    sw::Image image(5, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 5; ++x) image.at(x, y) = Color(0.5f, 0.25f, 2);
    return image;
}

}  // namespace

TEST_CASE("a picture without faults needs no word") {
    CHECK(findFaults(grey()).notFinite.count == 0);
    CHECK(findFaults(grey()).negative.count == 0);
    CHECK(describeFaults(grey(), 0, 0).empty());
}

TEST_CASE("NaN and infinite pixels are counted, negative ones apart, and the first is named") {
    sw::Image image = grey();
    image.at(3, 1) = Color(0, NAN, 0);
    image.at(0, 2) = Color(-infinity, 0, 0);
    image.at(4, 3) = Color(infinity, -infinity, NAN);
    image.at(2, 2) = Color(0, 0, -1e-6f);
    const PixelFaults faults = findFaults(image);
    CHECK(faults.notFinite.count == 3);
    CHECK((faults.notFinite.x == 3 && faults.notFinite.y == 1));
    CHECK(faults.negative.count == 1);
    CHECK(describeFaults(image, 10, 20) ==
          std::vector<std::string>{"warning: 3 pixels are NaN or infinite, the first at 13,21; to "
                                   "see its rays: --pixel 13,21",
                                   "warning: 1 pixel is negative, the first at 12,22; to see its "
                                   "rays: --pixel 12,22"});
}

TEST_CASE("a black picture has a word on where to look, one with a single spark has none") {
    sw::Image image(4, 6);
    CHECK(describeFaults(image, 10, 20) ==
          std::vector<std::string>{"warning: every pixel is black; to see why: --pixel 12,23"});
    image.at(3, 5) = Color(0, 1e-30f, 0);
    CHECK(describeFaults(image, 10, 20).empty());
}

TEST_CASE("the program warns of negative pixels and writes the picture all the same") {
    const TemporaryFolder folder;
    makeFile(folder / "dark.nff",
             "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 16 16\n"
             "l 0 0 9 -1 -1 -1\nf 1 1 1 1 0 0 0 1\ns 0 0 0 1\n");
    const Run run = swtracer(folder, "dark.nff -o a.png --crop 4,4,12,12 --stats s.json");
    CHECK(run.code == 0);
    CHECK(run.err.find(" pixels are negative, the first at ") != std::string::npos);
    CHECK(run.err.find(": warning: colour (-1, -1, -1) is negative") != std::string::npos);
    CHECK(lines(run.err) == 2);
    CHECK(fs::exists(folder / "a.png"));
    const std::string json = contentOf(folder / "s.json");
    CHECK(numberOf(json, "negative_pixels") > 20);
    CHECK(numberOf(json, "not_finite_pixels") == 0);
    CHECK(swtracer(folder, "dark.nff -o a.png --quiet").err.empty());
}
