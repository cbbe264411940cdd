// Renders whose end fails, and renders that are killed: work is not lost, nor left half done.
#include "app/shell.h"
#include "support.h"

#ifndef _WIN32  // links, mounts, fork()

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <new>
#include <thread>

#include "app/outputs.h"

using namespace test;

namespace {

const std::string tiny = "--size 4x4 --samples 2 ";

// Spoils a render's end after all checks: when the scene's warning appears, and the render begins.
Run spoiled(const TemporaryFolder& folder, const std::string& arguments, const std::string& how) {
    makeFile(folder / "odd.nff",
             contentOf(fs::path(SW_SCENES) / "one-triangle.nff") + "\nc 0 0 0 1 0 0 0 1\n");
    return shell(folder, "TMPDIR=tmp; export TMPDIR; $SW odd.nff --size 99x99 --time-limit 1 " +
                             arguments + " 2>err & while [ ! -s err ]; do sleep 0.02; done; " +
                             how + "; wait $!; code=$?; cat err >&2; rm err; exit $code");
}

bool mayMount(const TemporaryFolder& folder) {
    return shell(folder, "unshare -m true").code == 0;
}

}  // namespace

TEST_CASE("a file that cannot be written at the end is saved under a second name that is printed") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "taken");
    makeFile(folder / "taken/x", "x");
    makeFile(folder / "out-1.png", "another");
    // A folder with something in it cannot be replaced; writeFile() sees that as late as here.
    const std::string content(100000, 'c');
    CHECK(errorOf([&] { save(folder / "taken", content); }) ==
          (folder / "taken").string() +
              ": is a folder; expected the name of a file; what it should "
              "hold is in " +
              (folder / "taken-1").string());
    CHECK((contentOf(folder / "taken-1") == content));
    fs::create_directory(folder / "out.png");
    CHECK(
        has(errorOf([&] { save(folder / "out.png", content); }), (folder / "out-2.png").string()));
    CHECK((contentOf(folder / "out-2.png") == content));
    CHECK(contentOf(folder / "out-1.png") == "another");
    CHECK(folder.count() == 5);
}

TEST_CASE("a picture whose place is taken or gone while it is rendered is saved all the same") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "tmp");
    fs::create_directory(folder / "sub");
    const auto [arguments, how, place] = GENERATE(table<std::string, std::string, std::string>(
        {{"-o a.png", "mkdir a.png", "a-1.png"},
         {"-o sub/a.png", "rmdir sub", "tmp/a-1.png"},
         {"-o a.pfm", "mkdir a.pfm a-1.pfm", "a-2.pfm"},
         {"-o a.png", "ln -s a.png a.png", "a-1.png"},
         {"--stats s.json", "mkdir s.json", "s-1.json"},
         {"--error-image a.png", "mkdir a.png", "a-1.png"}}));
    CAPTURE(arguments);
    const Run run = spoiled(folder, arguments, how);
    CAPTURE(run.err);
    CHECK(run.code == 4);
    CHECK(lines(run.err) == 2);  // the warning, the error
    CHECK(has(run.err, "; what it should hold is in "));
    CHECK(has(run.err, place + "\n"));
    const std::string saved = contentOf(folder / place);
    if (fs::path(place).extension() == ".png") CHECK(PngStructure(saved).width == 99);
    CHECK(saved.size() > 50);
}

TEST_CASE("one output that goes to its second name does not keep the others from being written") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "tmp");
    const auto [taken, picture, errors, stats] =
        GENERATE(table<std::string, std::string, std::string, std::string>(
            {{"a.png", "a-1.png", "e.png", "s.json"},
             {"e.png", "a.png", "e-1.png", "s.json"},
             {"s.json", "a.png", "e.png", "s-1.json"},
             {"a.png s.json", "a-1.png", "e.png", "s-1.json"},
             {"a.png e.png s.json", "a-1.png", "e-1.png", "s-1.json"}}));
    CAPTURE(taken);
    const Run run =
        spoiled(folder, "-o a.png --error-image e.png --stats s.json", "mkdir " + taken);
    CAPTURE(run.err);
    CHECK(run.code == 4);
    CHECK(lines(run.err) == 2);  // the warning, the error
    for (const std::string& name : {picture, errors, stats})
        CHECK(has(run.err, name + "; ") + has(run.err, name + "\n") == has(name, "-1"));
    CHECK(PngStructure(contentOf(folder / picture)).width == 99);
    CHECK(PngStructure(contentOf(folder / errors)).width == 99);
    CHECK(numberOf(contentOf(folder / stats), "width") == 99);
}

TEST_CASE("memory that ends beside a second name does not lose that name") {
    const TemporaryFolder folder;
    const auto tooMuch = []() -> std::string { throw std::bad_alloc(); };
    std::string failure = "what it should hold is in a-1.png";
    saveBeside(folder / "s.json", tooMuch, failure);
    CHECK(failure == "what it should hold is in a-1.png; " + (folder / "s.json").string() +
                         ": too large for memory");
    failure.clear();
    CHECK_THROWS_AS(saveBeside(folder / "s.json", tooMuch, failure), std::bad_alloc);
    saveBeside("", tooMuch, failure);
    CHECK(failure.empty());
    CHECK(folder.count() == 0);
}

TEST_CASE("if no place is left for the picture, the statistics are written all the same") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    fs::create_directory(folder / "tmp");
    const Run run = spoiled(folder, "-o sub/a.png --stats s.json", "rm -r sub tmp");
    CAPTURE(run.err);
    CHECK(run.code == 4);
    CHECK(lines(run.err) == 2);
    CHECK_FALSE(has(run.err, "what it should hold"));
    CHECK(numberOf(contentOf(folder / "s.json"), "width") == 99);
}

#ifdef __linux__
TEST_CASE("a file that is mounted gets the picture, and stays mounted") {
    const TemporaryFolder folder;
    if (!mayMount(folder)) return;
    makeFile(folder / "real.png", "");
    makeFile(folder / "out.png", "");
    const Run run =
        shell(folder, "unshare -m sh -c \"mount --bind real.png out.png && \\\"$SW\\\" " + tiny +
                          "&& cmp real.png out.png\"");
    CAPTURE(run.err);
    CHECK(run.code == 0);
    CHECK((contentOf(folder / "real.png") == picture(tiny)));
    CHECK(contentOf(folder / "out.png").empty());
    CHECK(folder.count() == 2);
}
#endif

TEST_CASE(
    "a run that is killed leaves the old picture or the new one, and the next run cleans up") {
    const TemporaryFolder folder;
    const std::string arguments = "--quiet --size 40x40 --samples 1 --stats s.json";
    REQUIRE(swtracer(folder, arguments).code == 0);
    const std::string picture = contentOf(folder / "out.png");
    Random random(1);
    int killed = 0;
    for (int i = 0; i < 60; ++i) {
        const pid_t child = fork();
        if (child == 0) {
            if (chdir(folder.path.c_str()) == 0)
                execl(SW_PROGRAM, "swtracer", "--quiet", "--size", "40x40", "--samples", "1",
                      "--stats", "s.json", static_cast<char*>(nullptr));
            _exit(99);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(random.whole(0, 12000)));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        killed += WIFSIGNALED(status) ? 1 : 0;
        CHECK((contentOf(folder / "out.png") == picture));
        CHECK(numberOf(contentOf(folder / "s.json"), "total") >= 0);
    }
    CAPTURE(killed);
    CHECK(killed > 0);
    REQUIRE(swtracer(folder, arguments).code == 0);
    CHECK(folder.count() == 2);
}

#endif
