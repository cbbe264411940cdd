// Standard streams as scene and outputs, and results that do not arrive.
#include "app/shell.h"
#include "support.h"

#ifndef _WIN32  // scripts of the POSIX shell; numbers of streams as names

using namespace test;

namespace {

const std::string tiny = "--size 4x4 --samples 2 ";

bool isPng(const std::string& bytes) {
    PngStructure structure(bytes);  // throws unless that is all
    return structure.width == 4;
}

}  // namespace

TEST_CASE("a picture on standard output is only a picture, by any name") {
    const std::string name =
        GENERATE(as<std::string>(), "-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1");
    CAPTURE(name);
    const TemporaryFolder folder;
    if (name.substr(0, 5) == "/proc" && !fs::exists("/proc/self/fd")) return;
    const Run file = shell(folder, "$SW " + tiny + "-o " + name);
    CAPTURE(file.err);
    CHECK(file.code == 0);
    CHECK(isPng(file.out));
    CHECK(lines(file.err) == 1);  // the summary
    CHECK(has(file.err, " spp "));
    CHECK(isPng(shell(folder, "$SW " + tiny + "-o " + name + " | cat").out));
    CHECK(folder.count() == 0);
}

TEST_CASE("statistics and error image go to streams as well") {
    const TemporaryFolder folder;
    const Run out = shell(folder, "$SW " + tiny + "--stats -");
    CHECK(out.out.substr(0, 2) == "{\n");
    CHECK(out.out.substr(out.out.size() - 2) == "}\n");
    CHECK(lines(out.err) == 1);
    const Run err = shell(folder, "$SW " + tiny + "--stats /dev/stderr");
    CHECK(err.err.substr(0, 2) == "{\n");
    CHECK(lines(err.out) == 1);
    CHECK(isPng(shell(folder, "$SW " + tiny + "--quiet --error-image -").out));
    const Run both = shell(folder, "$SW " + tiny + "-o - --stats /dev/stderr --quiet");
    CHECK(isPng(both.out));
    CHECK(both.err.substr(0, 2) == "{\n");
}

TEST_CASE("a stream that is redirected to a log leaves the log's content and place") {
    const TemporaryFolder folder;
    makeFile(folder / "log", "before\n");
    const Run run =
        shell(folder, "{ $SW " + tiny + "--quiet --stats /dev/stdout; echo after; } >>log");
    CHECK(run.code == 0);
    const std::string log = contentOf(folder / "log");
    CHECK(startsWith(log, "before\n{\n"));
    CHECK(log.substr(log.size() - 8) == "}\nafter\n");
    const Run other =
        shell(folder, "{ echo first; $SW " + tiny + "-o /dev/fd/3 --quiet; } 3>pic >log");
    CHECK(other.code == 0);
    CHECK(isPng(contentOf(folder / "pic")));
    CHECK(contentOf(folder / "log") == "first\n");
    CHECK(folder.count() == 3);  // and out.png
}

TEST_CASE("a scene comes from standard input, a file there or a pipe") {
    const TemporaryFolder folder;
    const std::string scene = quoted(fs::path(SW_SCENES) / "mirrors.nff") + " ";
    const std::string expected = picture(scene + tiny + " --quiet");
    for (const std::string name : {"-", "/dev/stdin", "/dev/fd/0"}) {
        CAPTURE(name);
        CHECK(
            (shell(folder, "$SW " + name + " " + tiny + "--quiet -o - <" + scene).out == expected));
        CHECK((shell(folder, "cat " + scene + " | $SW " + name + " --quiet -o - " + tiny).out ==
               expected));
    }
    const Run bad = shell(folder, "echo s 1 | $SW -");
    CHECK(bad.code == 3);
    CHECK(startsWith(bad.err, "swtracer: /dev/stdin:1:"));
    CHECK(shell(folder, "$SW - <&-").code == 3);
}

TEST_CASE("one stream takes one output") {
    const TemporaryFolder folder;
    for (const std::string outputs : {"-o - --stats -", "-o - --error-image /dev/fd/1",
                                      "--stats /dev/stderr --error-image /dev/fd/2"}) {
        const Run run = shell(folder, "$SW " + tiny + outputs);
        CAPTURE(outputs, run.err);
        CHECK(run.code == 2);
        CHECK(run.out.empty());
        CHECK(lines(run.err) == 1);
    }
    CHECK(shell(folder, "$SW " + tiny + "-o - --stats a.json >>a.json").code == 2);
    CHECK(folder.count() == 1);
}

TEST_CASE("4 for a stream that is closed or open for reading before anything is rendered") {
    const TemporaryFolder folder;
    const std::string work = "--size 16384x8192 --samples 256 ";
    for (const std::string streams : {"-o - >&-", "-o /dev/fd/7", "--stats /dev/fd/7 7</dev/null",
                                      "--stats /dev/stdin </dev/null"}) {
        const Run run = shell(folder, "$SW " + work + streams);
        CAPTURE(streams, run.err);
        CHECK(run.code == 4);
        CHECK(lines(run.err) == 1);
        CHECK(has(run.err, "cannot write"));
    }
    CHECK(folder.count() == 0);
}

TEST_CASE("4 for a result that does not arrive at standard output") {
    const TemporaryFolder folder;
    const std::string what = GENERATE(as<std::string>(), "--help", "--version", "--pixel 1,1",
                                      "--size 4x4", "--size 4x4 --stats -", "--size 4x4 -o -");
    for (const std::string where : {">/dev/full", ">&-"}) {
        if (where == ">/dev/full" && !fs::exists("/dev/full")) continue;
        const Run run = shell(folder, "$SW " + what + " " + where);
        CAPTURE(what, where, run.err);
        CHECK(run.code == 4);
        CHECK(lines(run.err) == 1);
        CHECK(has(run.err, "cannot write"));
    }
    CHECK(shell(folder, "$SW --size 4x4 --quiet >&-").code == 0);
    CHECK(shell(folder, "$SW none.nff >&- 2>&-").code == 3);
}

TEST_CASE("a reader that has left ends the program without a word") {
    const TemporaryFolder folder;
    for (const std::string what : {"--help", "--pixel 1,1", "--size 4x4", "--size 4x4 -o -"}) {
        const Run run =
            shell(folder, "{ sleep 0.3; $SW " + what + "; echo $? >code; } | :; cat code; rm code");
        CAPTURE(what, run.err);
        CHECK(run.out == "141\n");  // 128 + SIGPIPE
        CHECK(run.err.empty());
    }
}

#endif
