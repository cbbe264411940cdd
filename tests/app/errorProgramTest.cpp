#include "app/programRun.h"
#include "png.h"
#include "support.h"

using namespace test;

namespace {

const std::string lab = "--quiet --size 48x48 ";

}  // namespace

TEST_CASE("every render with two samples or more prints its estimated error") {
    const double two = numberOf(statsOf(lab + "--samples 2"), "estimated_rmse");
    const double five = numberOf(statsOf(lab + "--samples 5"), "estimated_rmse");
    CHECK((0.001 < five && five < two && two < 0.2));
    CHECK(statsOf(lab + "--samples 1").find("\"estimated_rmse\": null") != std::string::npos);
    const TemporaryFolder folder;
    const std::string line = swtracer(folder, "--size 48x48").out;
    CHECK(line.find("  rmse 0.") != std::string::npos);
    CHECK(line.substr(line.size() - 8) == " (est.)\n");
}

TEST_CASE("the error has a standard error, and an audit counts its pixels") {
    const auto [way, audits] = GENERATE(table<std::string, bool>(
        {{"--samples 3", false}, {"--adaptive 0.02", true}, {"--target-rmse 0.02", true}}));
    CAPTURE(way);
    const std::string stats = statsOf(lab + way);
    const double rmse = numberOf(stats, "estimated_rmse");
    const double error = numberOf(stats, "estimated_rmse_standard_error");
    CHECK((error > 0.05 * rmse && error < 2 * rmse));
    CHECK((numberOf(stats, "audited_pixels") > 48 * 48 / 8) == audits);
    const TemporaryFolder folder;
    const std::string line = swtracer(folder, "--size 48x48 " + way).out;
    const auto at = line.find(" +- 0.");
    CHECK(at != std::string::npos);
    CHECK((line.find("  rmse 0.") < at && at < line.find(" (est.)")));
    const std::string none = statsOf(lab + "--samples 1");
    CHECK(none.find("\"estimated_rmse_standard_error\": null") != std::string::npos);
}

TEST_CASE("a target that the limit of samples keeps from being reached is named") {
    const TemporaryFolder folder;
    const std::string size = "--size 4x4 --target-rmse ";
    CHECK(swtracer(folder, size + "0.05").err.empty());
    CHECK(swtracer(folder, size + "1e-8").err.find("above the target") != std::string::npos);
}

TEST_CASE("each sampler makes a picture of its own, the same for any number of threads") {
    std::vector<std::string> pictures;
    for (const std::string sampler : {"jitter", "grid", "random", "multijitter"}) {
        const std::string arguments = lab + "--samples 2 --sampler " + sampler;
        pictures.push_back(picture(arguments + " --threads 1"));
        CHECK((picture(arguments + " --threads 3") == pictures.back()));
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i)
            CHECK((pictures[i] != pictures.back()));
    }
    CHECK((picture(lab + "--samples 2") == pictures.front()));
}

TEST_CASE("an adaptive picture depends on its tolerance and not on threads") {
    const std::string one = picture(lab + "--adaptive 0.05 --threads 1");
    CHECK((picture(lab + "--adaptive 0.05 --threads 3") == one));
    CHECK((picture(lab + "--adaptive 0.01") != one));
    CHECK((picture(lab + "--adaptive 0.05 --seed 2") != one));
}

TEST_CASE("an adaptive picture ends at the target error") {
    const double target = GENERATE(0.02, 0.01, 0.005);
    const std::string stats = statsOf(lab + "--target-rmse " + std::to_string(target));
    const double rmse = numberOf(stats, "estimated_rmse");
    CAPTURE(target, rmse);
    CHECK(rmse <= target);
    CHECK(rmse > target / 2);
    CHECK(numberOf(stats, "samples_per_pixel") >= 1);
}

TEST_CASE("a time limit ends a picture that would take for ever") {
    const std::string stats = statsOf("--quiet --time-limit 0.3");
    CHECK(numberOf(stats, "trace") < 5);
    CHECK(numberOf(stats, "estimated_rmse") > 0);
}

TEST_CASE("the error image has the size of the picture and shows its edges alone") {
    const std::string way = GENERATE("--samples 3", "--adaptive 0.02");
    const TemporaryFolder folder;
    const Run run = swtracer(folder, lab + way + " --crop 3,2,40,30 --error-image e.png");
    CAPTURE(way, run.err);
    REQUIRE(run.code == 0);
    const PngStructure structure(contentOf(folder / "e.png"));
    CHECK((structure.width == 37 && structure.height == 28));
#if SW_TEST_DECODES_PNG
    // Red begins where blue, 0.001, ends.
    std::size_t red = 0;
    const auto bytes = decodePng(contentOf(folder / "e.png"));
    for (std::size_t i = 0; i < bytes.size(); i += 3) red += bytes[i] > 128;
    CAPTURE(red);
    CHECK(red > bytes.size() / 3 / 50);
    CHECK(red < bytes.size() / 3 / 2);
#endif
}
