#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/programRun.h"
#include "nff/shippedScenes.h"
#include "tools/common/html.h"
#include "tools/common/powerLaw.h"
#include "tools/common/table.h"

using namespace report;
using html::base64;
using html::escaped;
using namespace test;

namespace {

std::vector<Point> powerLaw(double factor, double exponent) {
    std::vector<Point> points;
    for (int n = 1; n <= 8; ++n)
        points.push_back({1.0 * n * n, factor * std::pow(n * n, exponent)});
    return points;
}

std::vector<std::string> split(const std::string& text, char end) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, end);) parts.push_back(part);
    if (!text.empty() && text.back() == end && end == ',') parts.emplace_back();
    return parts;
}

// The folder that a quick run on the lab scene fills.
void study(const TemporaryFolder& folder) {
    const Run run =
        runProgram(SW_REPORT, folder,
                   "convergence --quick --output out " + quoted(shippedFolder / "cornell.nff"));
    INFO(run.err);
    REQUIRE(run.code == 0);
}

}  // namespace

TEST_CASE("the slope of an exact power law is its exponent") {
    for (const double exponent : {-2.0, -0.75, -0.5, 0.0, 1.0}) {
        for (const double factor : {1e-6, 0.3, 1e6}) {
            CAPTURE(exponent, factor);
            const PowerLaw law = fitPowerLaw(powerLaw(factor, exponent));
            CHECK(std::fabs(law.exponent - exponent) < 1e-12);
            CHECK(std::fabs(law.factor / factor - 1) < 1e-12);
        }
    }
}

TEST_CASE("the slope is that of least squares") {
    // Errors of +1, -2, +1 in the logarithms of equidistant points do not turn the line.
    const double e = std::exp(1.0);
    const std::vector<Point> points{{1, e}, {10, 10 / e / e}, {100, 100 * e}};
    const PowerLaw law = fitPowerLaw(points);
    CHECK(std::fabs(law.exponent - 1) < 1e-12);
    CHECK(std::fabs(law.factor - 1) < 1e-12);
}

TEST_CASE("points without logarithm do not count, and too few points have no slope") {
    std::vector<Point> points = powerLaw(2, -0.5);
    points.push_back({64, 0});
    points.push_back({0, 1});
    points.push_back({1, NAN});
    CHECK(std::fabs(fitPowerLaw(points).exponent + 0.5) < 1e-12);
    CHECK(std::isnan(fitPowerLaw({}).exponent));
    CHECK(std::isnan(fitPowerLaw({{3, 4}}).exponent));
    for (double x = 0.1; x < 100; x *= 1.3)  // some have a mean that differs from them by rounding
        CHECK(std::isnan(fitPowerLaw({{x, 4}, {x, 5}, {x, 6}}).exponent));
}

TEST_CASE("a curve reaches each of its values where a power law says") {
    const std::vector<Point> points = powerLaw(2, -0.75);
    for (double x = 1; x <= 64; x *= 1.37)
        CHECK(std::fabs(firstReach(points, 2 * std::pow(x, -0.75)) / x - 1) < 1e-12);
    CHECK(firstReach(points, 100) == 1);
    CHECK(std::isnan(firstReach(points, 1e-3)));
    CHECK(std::isnan(firstReach({}, 1)));
    CHECK(firstReach({{1, 1}, {2, 0}}, 0.5) == 2);
}

TEST_CASE("the geometric mean of reciprocals is the reciprocal mean") {
    CHECK(std::fabs(geometricMean({2, 8}) - 4) < 1e-12);
    CHECK(std::fabs(geometricMean({0.5, 0.125}) - 0.25) < 1e-12);
    CHECK(std::isnan(geometricMean({})));
}

TEST_CASE("base64 agrees with the vectors of RFC 4648") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string("\xfb\xff\xfe\0", 4)) == "+//+AA==");
}

TEST_CASE("any text in a page is escaped") {
    CHECK(escaped("a<b> & \"c\"") == "a&lt;b&gt; &amp; &quot;c&quot;");
    CHECK(htmlTable({{"<", "n"}, {"a", "1"}}, 1).find("<th>&lt;</th>") != std::string::npos);
}

TEST_CASE("the CSV has a row for every method and setting, and all of its numbers") {
    const TemporaryFolder folder;
    study(folder);
    const auto rows = split(contentOf(folder.path / "out" / "convergence.csv"), '\n');
    REQUIRE(rows.size() == 1 + 4 * 2 + 2);
    CHECK(startsWith(rows[0], "scene,method,setting,spp,rays,seconds,rmse,"));
    const std::size_t columns = split(rows[0], ',').size();
    for (std::size_t i = 1; i < rows.size(); ++i) {
        CAPTURE(rows[i]);
        const auto cells = split(rows[i], ',');
        REQUIRE(cells.size() == columns);
        const double spp = std::stod(cells[3]), rmse = std::stod(cells[6]);
        CHECK(cells[0] == "cornell");
        CHECK(std::stod(cells[4]) >= spp * 24 * 24);
        CHECK(std::stod(cells[5]) > 0);
        CHECK((rmse > 0 && rmse < 0.5));
        CHECK(std::fabs(std::stod(cells[7]) + 20 * std::log10(rmse)) < 0.001);
        CHECK((std::stod(cells[8]) >= rmse && std::stod(cells[8]) <= 1));
        if (cells[2] == "1x1")
            CHECK(cells[10].empty());
        else
            CHECK(std::stod(cells[10]) > 0);
    }
}

TEST_CASE("the page is self-contained") {
    const TemporaryFolder folder;
    study(folder);
    const std::string page = contentOf(folder.path / "out" / "index.html");
    REQUIRE(startsWith(page, "<!DOCTYPE html>"));
    CHECK(page.find("http") == std::string::npos);
    for (const std::string what : {"src=", "href=", "url("})
        for (auto at = page.find(what); at != std::string::npos; at = page.find(what, at + 1)) {
            const std::string target = page.substr(at + what.size(), 12);
            CHECK((startsWith(target, "\"data:image/") || startsWith(target, "\"#")));
        }
    // The reference and the errors of four samplers and adaptive sampling, at least.
    CHECK(fs::exists(folder.path / "out" / "cornell-reference.png"));
    std::size_t pictures = 0;
    for (auto at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1))
        ++pictures;
    CHECK(pictures >= 6);
}

TEST_CASE("without gnuplot the tables remain, and the page says what is missing") {
    const TemporaryFolder folder;
    const Run run =
        runProgram(SW_REPORT, folder,
                   "convergence --quick --output out " + quoted(shippedFolder / "one-triangle.nff"),
                   "PATH=/nowhere; ");
    CHECK(run.code == 0);
    const std::string page = contentOf(folder.path / "out" / "index.html");
    CHECK(page.find("gnuplot is not installed") != std::string::npos);
    CHECK(page.find("<table>") != std::string::npos);
    CHECK(lines(contentOf(folder.path / "out" / "convergence.csv")) == 11);
}

TEST_CASE("scenes that cannot be studied end the program with a reason") {
    const TemporaryFolder folder;
    CHECK(runProgram(SW_REPORT, folder, "convergence --quick none.nff").code == 3);
    const std::string lab = quoted(shippedFolder / "cornell.nff");
    const Run twice = runProgram(SW_REPORT, folder, "convergence --quick " + lab + " " + lab);
    CHECK(twice.code == 2);
    CHECK(twice.err.find("different names") != std::string::npos);
}
