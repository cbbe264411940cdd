#include "app/programRun.h"
#include "support.h"

using namespace test;

namespace {

const std::string tiny = "--size 4x4 --samples 1 ";

// Runs the program, which must fail with this code, one line on stderr that holds the text, and no
// new file.
void checkFailure(const TemporaryFolder& folder, int code, const std::string& arguments,
                  const std::string& text, const std::string& before = "") {
    const int filesBefore = folder.count();
    const Run run = swtracer(folder, arguments, before);
    CAPTURE(arguments, run.out, run.err);
    CHECK(run.code == code);
    CHECK(run.out.empty());
    CHECK(lines(run.err) == 1);
    CHECK(run.err.substr(0, 10) == "swtracer: ");
    CHECK(run.err.find(text) != std::string::npos);
    CHECK(folder.count() == filesBefore);
}

void checkFailure(int code, const std::string& arguments, const std::string& text) {
    checkFailure(TemporaryFolder(), code, arguments, text);
}

}  // namespace

TEST_CASE("2 for a size that makes no picture") {
    const auto size = GENERATE(as<std::string>(), "0x10", "10x0", "0x0", "-5x10", "10x-5",
                               "16385x1", "1x16385", "99999999999x1", "10", "10x", "x10",
                               "10x10x10", "10,10", "1e2x10", "axb", "10x10px");
    checkFailure(2, "--size=" + size, "--size: expected WIDTHxHEIGHT, each from 1 to 16384");
}

TEST_CASE("2 for numbers out of range and text that is not a number") {
    const auto [option, value] = GENERATE(table<std::string, std::string>({{"--samples", "0"},
                                                                           {"--samples", "-1"},
                                                                           {"--samples", "257"},
                                                                           {"--samples", "1.5"},
                                                                           {"--samples", "many"},
                                                                           {"--depth", "-1"},
                                                                           {"--depth", "1001"},
                                                                           {"--depth", "3x"},
                                                                           {"--threads", "-1"},
                                                                           {"--threads", "1025"},
                                                                           {"--seed", "x"},
                                                                           {"--gamma", "0"},
                                                                           {"--gamma", "-2"},
                                                                           {"--gamma", "11"},
                                                                           {"--gamma", "nan"},
                                                                           {"--gamma", "inf"}}));
    checkFailure(2, tiny + option + "=" + value, option);
}

TEST_CASE("2 for a crop that is outside the picture or malformed") {
    for (const std::string crop : {"0,0,0,5", "5,0,5,9", "5,0,4,9", "0,9,5,9", "-1,0,5,5",
                                   "0,-1,5,5", "0,0,5", "0,0,5,5,5", "0,0,5,x"})
        checkFailure(2, tiny + "--crop=" + crop, "--crop");
    for (const std::string crop : {"0,0,5,4", "0,0,4,5", "4,4,5,5", "0,0,99999,1"})
        checkFailure(2, tiny + "--crop=" + crop, "--crop: expected a window within 4x4");
}

TEST_CASE("2 for two ways of sampling at once") {
    for (const std::string way : {"--adaptive", "--target-rmse", "--time-limit"})
        for (const std::string other : {"--samples=2", "--sampler=grid", "--corners"})
            checkFailure(2, way + "=0.5 " + other,
                         way + ": expected no " + other.substr(0, other.find('=')) + " beside it");
    checkFailure(2, "--corners --sampler grid", "--corners: expected no --sampler beside it");
}

TEST_CASE("2 for errors and times that are not positive numbers") {
    for (const std::string way : {"--adaptive", "--target-rmse", "--time-limit"})
        for (const std::string value : {"0", "-1", "x", "nan", "inf"})
            checkFailure(2, way + "=" + value, way);
}

TEST_CASE("2 for an error image without an error estimate") {
    checkFailure(2, "--samples 1 --error-image e.png", "--error-image: expected --samples 2");
    checkFailure(2, "--corners --error-image e.png", "--error-image: expected --samples 2");
    checkFailure(2, "--sampler sobol", "--sampler");
}

TEST_CASE("2 for samples beside rays at corners") {
    checkFailure(2, "--corners --samples 3", "--corners: expected no --samples beside it");
    checkFailure(2, "--samples 1 --corners", "--corners: expected no --samples beside it");
}

TEST_CASE("2 for options that do not exist and values that are missing") {
    checkFailure(2, "--sizes 4x4", "--sizes");
    checkFailure(2, "-z", "-z");
    checkFailure(2, "a.nff b.nff", "b.nff");
    for (const std::string option : {"--size", "--size=", "--samples", "-o", "--stats", "--crop"})
        checkFailure(2, option, option.substr(0, option.find('=')));
}

TEST_CASE("3 for a scene that is missing unreadable or malformed") {
    const TemporaryFolder folder;
    checkFailure(folder, 3, "none.nff", "none.nff: not found; is the path right?");
    checkFailure(folder, 3, "/none/my.nff", "my.nff: not found");  // no option, on Windows either
    checkFailure(folder, 3, ".", "is a folder");
    makeFile(folder / "empty.nff", "");
    checkFailure(folder, 3, "empty.nff", "empty.nff:1:1: expected a view");
    makeFile(folder / "bad.nff", "b 0 0 0\ns 1 2 3 4\n");
    checkFailure(folder, 3, "bad.nff", "bad.nff:2:1: expected a material");
}

TEST_CASE("4 for an output folder that is missing or not a folder") {
    const TemporaryFolder folder;
    makeFile(folder / "file", "x");
    for (const std::string option : {"-o ", "--output=", "--stats "}) {
        checkFailure(folder, 4, tiny + option + "missing/a.png", "there is no folder");
        checkFailure(folder, 4, tiny + option + "file/a.png", "cannot write");
        checkFailure(folder, 4, tiny + option + ".", "is a folder");
    }
    CHECK(contentOf(folder / "file") == "x");
}

TEST_CASE("2 for an empty value of any option and an empty scene") {
    for (const std::string option :
         {"-o", "--size", "--samples", "--sampler", "--adaptive", "--target-rmse", "--time-limit",
          "--depth", "--threads", "--seed", "--crop", "--gamma", "--pixel", "--stats",
          "--error-image", "--explore"})
        checkFailure(2, option + " \"\"",
                     option == "-o" ? "--output: expected" : option + ": expected");
    checkFailure(2, tiny + "\"\"", "scene: expected the name of a file");
}

TEST_CASE("the scene is checked before the output and both before any work") {
    const std::string work = "--size 16384x8192 --samples 256 ";
    checkFailure(3, work + "none.nff -o missing/a.png", "not found");
    checkFailure(4, work + "-o missing/a.png", "there is no folder");
    checkFailure(4, work + "--stats missing/a.json", "there is no folder");
}

#ifndef _WIN32  // the limits of a POSIX shell; /proc

TEST_CASE("3 for a scene that fails while it is read") {
    if (fs::exists("/proc/self/mem")) checkFailure(3, tiny + "/proc/self/mem", "cannot read");
}

TEST_CASE("4 for a full disk and the old picture stays") {
    const TemporaryFolder folder;
    const std::string old = "\x89PNG\r\n\x1a\nold";
    makeFile(folder / "a.png", old);
    // No file may grow beyond a block or two; the picture of 200 x 200 pixels does.
    checkFailure(folder, 4, "--size 200x200 --samples 1 -o a.png", "a.png: cannot write",
                 "export TMPDIR=.; ulimit -f 2; ");
    CHECK(contentOf(folder / "a.png") == old);
}

TEST_CASE("4 for a picture that is larger than any file may be before it is rendered") {
    const TemporaryFolder folder;
    const std::string work = "--size 2000x2000 --samples 256 ";
    for (const std::string name : {"a.png", "a.pfm", "a.hdr"})
        checkFailure(folder, 4, work + "-o " + name, name + ": cannot write", "ulimit -f 2; ");
    CHECK(folder.count() == 0);
}

TEST_CASE("4 for a picture that reaches the limit of a file's size while it is written") {
    const TemporaryFolder folder;
    const std::string work = "--size 99x99 --samples 1 -o a.png";
    const std::size_t size = picture("--size 99x99 --samples 1").size();
    REQUIRE(size > 3 * 1024);
    for (std::size_t blocks = 1; blocks * 1024 < size; ++blocks)  // of 512 or 1024 bytes
        checkFailure(folder, 4, work, "a.png: cannot write: ",
                     "export TMPDIR=.; ulimit -f " + std::to_string(blocks) + "; ");
    CHECK(folder.count() == 0);
}

TEST_CASE("a picture too large for memory is refused in one line") {
    // A gibibyte of address space holds the program, but not 3 GiB of pixels.
    const TemporaryFolder folder;
    const std::string limit = "ulimit -v 1000000 && ";
    if (swtracer(folder, "--version", limit).code != 0) return;  // no such limit, or a sanitizer
    const Run run = swtracer(folder, "--size 16384x16384", limit);
    CAPTURE(run.err);
    CHECK(run.code == 2);
    CHECK(lines(run.err) == 1);
    CHECK(run.err.find("too large for memory") != std::string::npos);
    CHECK(folder.count() == 0);
}

#endif
