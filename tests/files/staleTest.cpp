// Temporary files that killed runs leave behind.
#ifndef _WIN32  // Windows does not tell by its number whether a process runs

#include "files/temporary.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include "files.h"
#include "support.h"

using namespace sw;
using namespace test;

namespace {

// A process that no longer runs.
std::string deadProcess() {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    waitpid(child, nullptr, 0);
    return std::to_string(child);
}

}  // namespace

TEST_CASE("what a killed process left beside a target is removed and nothing else") {
    const std::string dead = deadProcess(), own = std::to_string(getpid());
    const TemporaryFolder folder;
    const std::string stale = ".a.png.swtracer-" + dead + "-";
    const std::vector<std::string> removed = {stale + "1.tmp", stale + "4294967295.tmp"};
    const std::vector<std::string> kept = {".a.png.swtracer-" + own + "-1.tmp",
                                           ".a.png.swtracer-1-1.tmp",
                                           ".b.png.swtracer-" + dead + "-1.tmp",
                                           "a.png.swtracer-" + dead + "-1.tmp",
                                           stale + "1.tmp.bak",
                                           stale + "x.tmp",
                                           stale + ".tmp",
                                           stale + "1",
                                           "a.png.tmp",
                                           ".a.png.swtracer--1.tmp",
                                           ".a.png.swtracer-0-1.tmp",
                                           ".a.png.swtracer-x-1.tmp"};
    for (const auto& names : {removed, kept})
        for (const std::string& name : names) makeFile(folder / name, "x");
    fs::create_directory(folder / (stale + "2.tmp"));
    fs::create_symlink("a.png.tmp", folder / (stale + "3.tmp"));
    const int before = folder.count();
    const bool asked = GENERATE(false, true);
    if (asked)
        requireWritable(folder / "a.png");
    else
        writeFile(folder / "a.png", "new");
    for (const std::string& name : removed) CHECK_FALSE(fs::exists(folder / name));
    for (const std::string& name : kept) {
        CAPTURE(name);
        CHECK(contentOf(folder / name) == "x");
    }
    CHECK(folder.count() == before - 2 + (asked ? 0 : 1));
}

TEST_CASE("a temporary file of yesterday is stale though its number runs again") {
    const TemporaryFolder folder;
    const fs::path file = folder / (".a.swtracer-" + std::to_string(getpid()) + "-1.tmp");
    makeFile(file, "x");
    removeStale(folder / "a");
    CHECK(fs::exists(file));
    fs::last_write_time(file, fs::last_write_time(file) - std::chrono::hours(25));
    removeStale(folder / "a");
    CHECK_FALSE(fs::exists(file));
}

TEST_CASE("the temporary file of a killed process bears a name that the next run removes") {
    const std::string name = GENERATE(as<std::string>(), "a", "a b.png", "\xc3\xbc.png", "-1-2.tmp",
                                      ".a.swtracer-1-1.tmp");
    const TemporaryFolder folder;
    const pid_t child = fork();
    if (child == 0) {
        new Temporary(folder / name, name);  // and its destructor never runs
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(status == 0);
    CHECK(folder.count() == 1);
    requireWritable(folder / name);
    CHECK(folder.count() == 0);
}

TEST_CASE("a name may be as long as the file system allows") {
    const TemporaryFolder folder;
    std::string umlauts;
    for (int i = 0; i < 127; ++i) umlauts += "\xc3\xbc";
    for (const std::string& name : {std::string(255, 'a'), umlauts, "a" + umlauts}) {
        makeFile(folder / name, "old");
        CHECK(errorOf([&] { writeFile(folder / name, "new"); }).empty());
        CHECK(contentOf(folder / name) == "new");
    }
    CHECK(folder.count() == 3);
}

#endif
