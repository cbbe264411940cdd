// The words of the command line: errors, help.
#include "app/shell.h"
#include "support.h"

using namespace test;

namespace {

std::string errorLine(const std::string& arguments) {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, arguments);
    CAPTURE(arguments, run.err);
    CHECK(run.code == 2);
    CHECK(lines(run.err) == 1);
    return run.err;
}

}  // namespace

TEST_CASE("a number out of its range is told the range") {
    const auto [option, value, expected] = GENERATE(table<std::string, std::string, std::string>(
        {{"--samples", "0", "expected a whole number from 1 to 256, found 0"},
         {"--samples", "1.5", "expected a whole number from 1 to 256, found 1.5"},
         {"--samples", "0x3", "expected a whole number from 1 to 256, found 0x3"},
         {"--depth", "1001", "expected a whole number from 0 to 1000, found 1001"},
         {"--threads", "many", "expected a whole number from 0 to 1024, found many"},
         {"--seed", "-1", "expected a whole number from 0 to 18446744073709551615, found -1"},
         {"--seed", "18446744073709551616",
          "expected a whole number from 0 to 18446744073709551615, found 18446744073709551616"},
         {"--gamma", "0", "expected a number from 0.1 to 10, found 0"},
         {"--gamma", "nan", "expected a number from 0.1 to 10, found nan"},
         {"--gamma", "2,2", "expected a number from 0.1 to 10, found 2,2"},
         {"--adaptive", "0", "expected a number from 1e-09 to 1e+09, found 0"},
         {"--time-limit", "1e400", "expected a number from 1e-09 to 1e+09, found 1e400"},
         {"--sampler", "sobol", "expected jitter, grid, random or multijitter, found sobol"}}));
    CHECK(errorLine(option + "=" + value) == "swtracer: " + option + ": " + expected + "\n");
}

TEST_CASE("a number is decimal whatever zeros it starts with") {
    const std::string arguments = "--size 4x4 --quiet ";
    CHECK((picture(arguments + "--samples 010") == picture(arguments + "--samples 10")));
}

TEST_CASE("a value that is missing or given twice is told so") {
    CHECK(errorLine("--samples") == "swtracer: --samples: expected one value, found none\n");
    CHECK(errorLine("--size=") == "swtracer: --size: expected one value, found none\n");
    CHECK(errorLine("--depth 1 --depth 2") ==
          "swtracer: --depth: expected one value, found several\n");
}

TEST_CASE("a mistyped option is told the nearest one") {
    const auto [typed, nearest] =
        GENERATE(table<std::string, std::string>({{"--sizes", "--size"},
                                                  {"--sice=4x4", "--size"},
                                                  {"-size", "--size"},
                                                  {"--Depth", "--depth"},
                                                  {"--sample", "--samples"},
                                                  {"--treads", "--threads"},
                                                  {"--ouput", "--output"},
                                                  {"--timelimit", "--time-limit"},
                                                  {"--error_image", "--error-image"},
                                                  {"-O", "-o"},
                                                  {"--halp", "--help"},
                                                  {"--stat", "--stats"}}));
    const std::string line = errorLine(typed + " 3");
    CAPTURE(typed, line);
    CHECK(has(line, typed + ": there is no such option; did you mean " + nearest + "? (--help"));
}

TEST_CASE("what is near no option is told of the help alone") {
    for (const std::string typed : {"--xyzzy", "-z", "--antialiasing"}) {
        const std::string line = errorLine(typed);
        CHECK(line == "swtracer: " + typed + ": there is no such option (--help lists all)\n");
    }
    CHECK(has(errorLine("a.nff b.nff"), "expected one scene, found another one: 'b.nff'"));
}

TEST_CASE("the help has groups, three examples that work, and the exit codes") {
    const TemporaryFolder folder;
    const std::string help = swtracer(folder, "--help").out;
    for (const std::string part :
         {"\nPicture:\n", "\nRays:\n", "\nAdaptive sampling:\n", "\nExamples:\n",
          "Exit codes: 0 done, 2 command line or too little memory, 3 scene, "})
        CHECK(has(help, part));
    fs::copy_file(fs::path(SW_SCENES) / "one-triangle.nff", folder / "my.nff");
    std::size_t at = help.find("\nExamples:\n") + 11;
    for (int i = 0; i < 3; ++i) {
        const std::string line = help.substr(at, help.find('\n', at) - at);
        const std::string words = line.substr(2, line.find("   ", 2) - 2);
        CAPTURE(line, words);
        REQUIRE(startsWith(words, "swtracer"));
        CHECK(swtracer(folder, words.substr(8)).code == 0);
        at += line.size() + 1;
    }
}

TEST_CASE("control characters in names do not break a message or the summary") {
    const TemporaryFolder folder;
#ifndef _WIN32  // where names have no such characters
    const Run none = shell(folder, "$SW \"$(printf \"a\\nb\\033[2J.nff\")\"");
    CHECK(none.code == 3);
    CHECK(none.err == "swtracer: a\\x0ab\\x1b[2J.nff: not found; is the path right?\n");
    const Run done = shell(folder, "$SW --size 4x4 -o \"$(printf \"a\\nb\\177.png\")\"");
    CHECK(done.code == 0);
    CHECK(lines(done.out) == 1);
    CHECK(has(done.out, "a\\x0ab\\x7f.png  4x4"));
    CHECK(fs::exists(folder / "a\nb\x7f.png"));
#endif
}

#ifdef __linux__
TEST_CASE("4 for a relative output in a working folder that was removed") {
    const TemporaryFolder folder;
    const std::string gone = "mkdir gone; cd gone; rmdir ../gone; $SW --size 4x4 ";
    for (const std::string what : {"", "-o a.png", "-o /dev/null --stats s.json"}) {
        const Run run = shell(folder, gone + what);
        CAPTURE(what, run.err);
        CHECK(run.code == 4);
        CHECK(lines(run.err) == 1);
        CHECK(has(run.err, "the working folder does not exist any more"));
    }
    const Run other = shell(folder, gone + "-o " + (folder / "a.png").string());
    CHECK(other.code == 0);
    CHECK(has(other.out, (folder / "a.png").string() + "  4x4"));
}
#endif
