#include "app/childProcess.h"
#include "app/programRun.h"
#include "support.h"

#ifndef _WIN32  // signals that a process sends another

using namespace test;

namespace {

using Words = std::vector<std::string>;

// Two shells of glass that face each other: at depth 40, no pixel of them is ever done.
const char* const shells =
    "v\nfrom 0 0 12\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 64 64\nb 0 0 1\n"
    "l 10 10 10\nf 0.9 0.9 0.9 0 0.3 1 0.6 1.3\n"
    "s -2.1 0 0 2\ns -2.1 0 0 1.8\ns 2.1 0 0 2\ns 2.1 0 0 1.8\n";

// Renders for longer than any test; sends a signal after some time.
Ending interrupted(const TemporaryFolder& folder, const Words& words, int signal, double after) {
    ChildProcess child(folder, words);
    pause(after);
    child.send(signal);
    return child.wait();
}

bool isWholePng(const std::string& bytes) {
    return bytes.size() > 50 && bytes.compare(1, 3, "PNG") == 0 &&
           bytes.compare(bytes.size() - 8, 4, "IEND") == 0;
}

}  // namespace

TEST_CASE("a signal ends a render at once, says so, and leaves the old picture") {
    const auto signal = GENERATE(SIGINT, SIGTERM);
    const auto words =
        GENERATE(Words{"--samples", "256"}, Words{"--adaptive", "1e-6", "--size", "3000x3000"},
                 Words{"--corners", "--size", "5000x5000"}, Words{"shells.nff", "--depth", "40"});
    const TemporaryFolder folder;
    makeFile(folder / "shells.nff", shells);
    makeFile(folder / "out.png", "");
    const Ending end = interrupted(folder, words, signal, 0.5);
    CAPTURE(signal, words, end.err);
    CHECK(end.code == 128 + signal);
    CHECK(end.out.empty());
    CHECK(lines(end.err) == 1);
    CHECK(has(end.err, signal == SIGINT ? "interrupted by SIGINT" : "interrupted by SIGTERM"));
    CHECK(contentOf(folder / "out.png").empty());
    CHECK(folder.count() == 2);
}

TEST_CASE("an adaptive render that a signal ends writes what it has") {
    const auto words =
        GENERATE(Words{"--adaptive", "1e-6", "--size", "64x64"},
                 Words{"--target-rmse", "1e-7", "--size", "64x64"}, Words{"--time-limit", "1000"});
    const TemporaryFolder folder;
    const Ending end = interrupted(folder, words, SIGINT, 0.5);
    CAPTURE(words, end.err);
    CHECK(end.code == 130);
    CHECK(has(end.err, "out.png has the picture so far"));
    CHECK(lines(end.out) == 1);
    CHECK(isWholePng(contentOf(folder / "out.png")));
    CHECK(folder.count() == 1);
}

TEST_CASE("a signal that was ignored at the start stays so") {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, "--time-limit 1 --quiet",
                             "trap '' INT; (sleep 0.3; kill -INT $$) & exec ");
    CHECK(run.code == 0);
}

TEST_CASE("a signal at any time leaves the old picture or a new one, and nothing beside it") {
    Random random(GENERATE(range(0u, 20u)));
    const TemporaryFolder folder;
    const int signal = random.whole(0, 1) == 0 ? SIGINT : SIGKILL;
    makeFile(folder / "out.png", "");
    const double after = random.real(0, 0.25f);
    const Ending end =
        interrupted(folder, {"--samples", "1", "--size", "512x512", "--quiet"}, signal, after);
    CAPTURE(signal, after, end.code, end.signal, end.err);
    CHECK((end.code == 0 || end.code == 130 || end.signal == signal));
    const std::string picture = contentOf(folder / "out.png");
    CHECK((picture.empty() || isWholePng(picture)));
    if (end.code == 130) CHECK(folder.count() == 1);
}

TEST_CASE("a preview is whole, follows the render, and stays where a signal ends it") {
    const TemporaryFolder folder;
    makeFile(folder / "shells.nff", shells);
    const auto words = GENERATE(Words{"--samples", "48", "--preview", "-o", "a.png"},
                                Words{"--adaptive", "1e-6", "--preview", "-o", "a.png"});
    ChildProcess child(folder, words);
    REQUIRE(comesTrue([&] { return fs::exists(folder / "a.png"); }));
    const std::string first = contentOf(folder / "a.png");
    CHECK(isWholePng(first));
    CHECK(comesTrue([&] { return contentOf(folder / "a.png") != first; }));
    child.send(SIGINT);
    const Ending end = child.wait();
    CHECK(end.code == 130);
    CHECK(isWholePng(contentOf(folder / "a.png")));
    CHECK(folder.count() == 2);
}

TEST_CASE("a preview leaves the picture that there would have been without") {
    const auto way = GENERATE("--samples 2 ", "--adaptive 0.05 ", "--sampler random ");
    const std::string arguments = way + std::string("--quiet --size 100x80 --crop 10,5,90,70");
    CHECK((picture(arguments + " --preview") == picture(arguments)));
}

TEST_CASE("2 for a preview on anything but a file") {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, "--preview --size 4x4 -o /dev/null");
    CHECK(run.code == 2);
    CHECK(has(run.err, "--preview: expected a file as output"));
    CHECK(swtracer(folder, "--preview --pixel 1,1").code == 2);
}

TEST_CASE("a time limit holds where a pixel would take for ever") {
    const TemporaryFolder folder;
    makeFile(folder / "shells.nff", shells);
    const Run run = swtracer(folder, "shells.nff --depth 40 --time-limit 1 --stats s.json");
    CHECK(run.code == 0);
    CHECK(lines(run.err) == 1);
    CHECK(has(run.err, "warning: there was no time for "));
    const std::string stats = contentOf(folder / "s.json");
    CHECK(numberOf(stats, "rough_pixels") > 200);
    CHECK(numberOf(stats, "rough_pixels") < 64 * 64);
    CHECK(numberOf(stats, "total") < 3);
}

#endif
