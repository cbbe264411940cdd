#include <cctype>
#include <cstdlib>
#include <vector>

#include "app/programRun.h"
#include "support.h"

using namespace test;

namespace {

const std::string small = "--quiet --size 24x16 --samples 2 ";
const std::string oneTriangle = quoted(fs::path(SW_SCENES) / "one-triangle.nff") + " ";
const std::string mirrors = quoted(fs::path(SW_SCENES) / "mirrors.nff") + " ";

}  // namespace

TEST_CASE("without arguments it renders the lab scene wherever it is started") {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, "--size 32x32 --samples 1");
    CHECK(run.code == 0);
    CHECK(run.err.empty());
    const std::string png = contentOf(folder / "out.png");
    CHECK(folder.count() == 1);
    const std::string named =
        quoted(fs::path(SW_SCENES) / "cornell.nff") + " --quiet --size 32x32 --samples 1";
    CHECK((png == picture(named)));
}

TEST_CASE("the scene sets the size unless the command line does") {
    const PngStructure fromScene(picture(oneTriangle + "--quiet --samples 1"));
    CHECK((fromScene.width == 512 && fromScene.height == 512));
    const PngStructure given(picture(oneTriangle + "--quiet --samples 1 --size 31x7"));
    CHECK((given.width == 31 && given.height == 7));
}

TEST_CASE("the summary is one line with the absolute path of the picture") {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, oneTriangle + "--size 24x16 --samples 2 --threads 1");
    CAPTURE(run.out);
    CHECK(lines(run.out) == 1);
    CHECK(run.out.substr(0, run.out.find("  ")) == (folder / "out.png").string());
    for (const std::string part :
         {"  24x16  ", "  4 spp  ", "  1 thread  ", " s  ", " Mray/s  rmse ", " (est.)\n"})
        CHECK(run.out.find(part) != std::string::npos);
    CHECK(run.err.empty());
}

TEST_CASE("quiet means silent") {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, oneTriangle + small + "--stats s.json");
    CHECK(run.code == 0);
    CHECK(run.out.empty());
    CHECK(run.err.empty());
    CHECK(folder.count() == 2);
}

TEST_CASE("the picture depends on the seed and not on the threads") {
    const std::string one = picture(mirrors + small + "--threads 1");
    CHECK((picture(mirrors + small + "--threads 2") == one));
    CHECK((picture(mirrors + small + "--threads 7") == one));
    CHECK((picture(mirrors + small) == one));
    CHECK((picture(mirrors + small + "--seed 1") == one));
    CHECK((picture(mirrors + small + "--seed 2") != one));
}

TEST_CASE("one sample has no jitter and samples depth and gamma change the picture") {
    const std::string arguments = mirrors + "--quiet --size 24x16 ";
    const std::string one = picture(arguments + "--samples 1");
    CHECK((picture(arguments + "--samples 1 --seed 99") == one));
    CHECK((picture(arguments + "--samples 2") != one));
    CHECK((picture(arguments + "--samples 1 --depth 0") != one));
    CHECK((picture(arguments + "--samples 1 --gamma 1") != one));
    // The defaults: 3 x 3 samples, depth 3, gamma 2.2.
    CHECK((picture(arguments) == picture(arguments + "--samples 3 --depth 3 --gamma 2.2")));
}

TEST_CASE("a crop of everything is the picture and two crops of one window agree") {
    const std::string all = picture(mirrors + small);
    CHECK((picture(mirrors + small + "--crop 0,0,24,16") == all));
    const std::string part = picture(mirrors + small + "--crop 3,2,20,9 --threads 1");
    CHECK((picture(mirrors + small + "--crop 3,2,20,9 --threads 3") == part));
    const PngStructure structure(part);
    CHECK((structure.width == 17 && structure.height == 7));
}

#if SW_TEST_DECODES_PNG
TEST_CASE("a crop is the same window of the full picture byte for byte") {
    Random random(GENERATE(range(0u, 5u)));
    constexpr int width = 40, height = 30;
    const int x0 = random.whole(0, width - 1), y0 = random.whole(0, height - 1);
    const int x1 = random.whole(x0 + 1, width), y1 = random.whole(y0 + 1, height);
    CAPTURE(x0, y0, x1, y1);
    const std::string sampling = GENERATE("--samples 2 ", "--corners ", "--adaptive 0.05 ");
    const std::string arguments = mirrors + "--quiet --size 40x30 " + sampling;
    const auto whole = decodePng(picture(arguments));
    std::vector<std::uint8_t> expected;
    for (int y = y0; y < y1; ++y)
        expected.insert(expected.end(), whole.begin() + 3 * (width * y + x0),
                        whole.begin() + 3 * (width * y + x1));
    const std::string crop = std::to_string(x0) + "," + std::to_string(y0) + "," +
                             std::to_string(x1) + "," + std::to_string(y1);
    CHECK((decodePng(picture(arguments + "--crop " + crop)) == expected));
}
#endif

TEST_CASE("the statistics hold size options and ray counts") {
    const std::string json = statsOf(
        mirrors + "--quiet --size 20x10 --samples 3 --depth 2 --threads 1 --seed 5 -o a.png");
    CHECK(json.substr(0, 2) == "{\n");
    CHECK(json.substr(json.size() - 2) == "}\n");
    CHECK(numberOf(json, "width") == 20);
    CHECK(numberOf(json, "height") == 10);
    CHECK(numberOf(json, "samples") == 3);
    CHECK(numberOf(json, "depth") == 2);
    CHECK(numberOf(json, "threads") == 1);
    CHECK(numberOf(json, "seed") == 5);
    const double primary = numberOf(json, "primary"), hits = numberOf(json, "primary_hits");
    CHECK(primary == 20 * 10 * 9);
    CHECK((hits > 0 && hits < primary));
    const double reflected = numberOf(json, "reflected");
    CHECK((reflected > 0 && reflected <= 2 * hits));
    CHECK(numberOf(json, "refracted") == 0);
    const double shadow = numberOf(json, "shadow");  // one light: at most one per hit
    CHECK((shadow > 0 && shadow <= hits + reflected));
    double sum = 0;
    for (const std::string step : {"load", "build", "record", "trace", "write"}) {
        CHECK(numberOf(json, step) >= 0);
        sum += numberOf(json, step);
    }
    CHECK(std::fabs(numberOf(json, "total") - sum) <= 1e-4 * sum);
}

TEST_CASE("a picture takes exactly the rays that it needs") {
    // A lone triangle that faces the light: every hit sends one shadow ray.
    const std::string json = statsOf(oneTriangle + "--quiet --size 30x20 -o a.png");
    CHECK(numberOf(json, "primary") == 30 * 20 * 9);
    CHECK(numberOf(json, "shadow") == numberOf(json, "primary_hits"));
    CHECK(numberOf(json, "reflected") + numberOf(json, "refracted") == 0);
    // At depth 0 mirrors reflect nothing.
    CHECK(numberOf(statsOf(mirrors + small + "--depth 0 -o a.png"), "reflected") == 0);
    // Statistics of a crop count its pixels alone.
    const std::string crop = statsOf(mirrors + small + "--crop 3,2,20,9 -o a.png");
    CHECK(numberOf(crop, "primary") == 17 * 7 * 4);
    CHECK(numberOf(crop, "width") == 17);
    CHECK(numberOf(crop, "height") == 7);
}

TEST_CASE("a picture from corner rays depends on the scene and its size alone") {
    const std::string arguments = mirrors + "--quiet --size 24x16 --corners ";
    const std::string one = picture(arguments + "--threads 1");
    CHECK((picture(arguments + "--threads 2") == one));
    CHECK((picture(arguments + "--threads 7 --seed 2") == one));
    CHECK((picture(arguments + "--depth 1") != one));
    CHECK((picture(mirrors + "--quiet --size 24x16 --samples 1") != one));
}

TEST_CASE("corner rays are counted once and make one sample per pixel") {
    const std::string arguments = mirrors + "--corners --size 24x16 ";
    const std::string whole = statsOf(arguments + "-o a.png");
    CHECK(numberOf(whole, "primary") == 25 * 17);
    CHECK(numberOf(whole, "width") == 24);
    CHECK(numberOf(whole, "samples") == 1);
    CHECK(whole.find("\"corners\": true") != std::string::npos);
    CHECK(numberOf(statsOf(arguments + "--crop 3,2,20,9 -o a.png"), "primary") == 18 * 8);
    const TemporaryFolder folder;
    CHECK(swtracer(folder, arguments).out.find("  24x16  1 spp  ") != std::string::npos);
}

TEST_CASE("warnings about the scene go to stderr unless --quiet is given") {
    const TemporaryFolder folder;
    makeFile(folder / "odd.nff",
             contentOf(fs::path(SW_SCENES) / "one-triangle.nff") + "\nc 0 0 0 1 0 0 0 1\n");
    const Run run = swtracer(folder, "odd.nff --size 4x4");
    CHECK(run.code == 0);
    CHECK(startsWith(run.err, "swtracer: odd.nff:"));
    CHECK(run.err.find(":1: warning: cone has no height") != std::string::npos);
    CHECK(lines(run.err) == 1);
    CHECK(swtracer(folder, "odd.nff --size 4x4 --quiet").err.empty());
}

TEST_CASE("the scene may come before and after any option") {
    const auto option =
        GENERATE(as<std::string>(), "--crop 3,2,20,9", "--seed 3", "--quiet", "--depth 1");
    CAPTURE(option);
    CHECK((picture(small + option + " " + mirrors) == picture(mirrors + small + option)));
}

TEST_CASE("help and version are not errors") {
    const TemporaryFolder folder;
    const Run help = swtracer(folder, "--help");
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    for (const std::string option :
         {"--output", "--size", "--samples", "--corners", "--depth", "--threads", "--seed",
          "--crop", "--gamma", "--quiet", "--stats", "--version", "scene"}) {
        CAPTURE(option);
        CHECK(help.out.find(option) != std::string::npos);
    }
    const Run version = swtracer(folder, "--version");
    CHECK(version.code == 0);
    CHECK(lines(version.out) == 1);
    CHECK(folder.count() == 0);
}
