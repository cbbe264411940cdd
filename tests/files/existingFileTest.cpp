// What an existing file keeps when it gets new content, and what is refused beforehand.
#ifndef _WIN32  // owners, modes and limits of POSIX

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "files.h"
#include "files/nobody.h"
#include "support.h"

using namespace sw;
using namespace test;

namespace {

unsigned modeOf(const fs::path& file) {
    return static_cast<unsigned>(fs::status(file).permissions()) & 07777;
}

// The error of both, which must be the same: before the work, and at its end.
std::string errorOfBoth(const fs::path& file) {
    const std::string before = errorOf([&] { requireWritable(file); });
    CHECK(errorOf([&] { writeFile(file, "new"); }) == before);
    return before;
}

}  // namespace

TEST_CASE("an existing file keeps its mode, and a new one gets the usual one") {
    const auto mode = GENERATE(0600u, 0640u, 0644u, 0660u, 0666u, 0700u, 0755u, 0777u);
    const TemporaryFolder folder;
    makeFile(folder / "a", "old");
    fs::permissions(folder / "a", fs::perms(mode));
    writeFile(folder / "a", "new");
    CHECK(contentOf(folder / "a") == "new");
    CHECK(modeOf(folder / "a") == mode);
    makeFile(folder / "usual", "");
    writeFile(folder / "b", "new");
    CHECK(modeOf(folder / "b") == modeOf(folder / "usual"));
}

TEST_CASE("root leaves a file to its owner") {
    if (geteuid() != 0) return;
    const TemporaryFolder folder;
    makeFile(folder / "a", "old");
    REQUIRE(chown((folder / "a").c_str(), 65534, 65533) == 0);
    writeFile(folder / "a", "new");
    struct stat now {};
    REQUIRE(stat((folder / "a").c_str(), &now) == 0);
    CHECK((now.st_uid == 65534 && now.st_gid == 65533));
}

TEST_CASE("all names of a file with several hard links get the new content") {
    const std::string content(GENERATE(0u, 1u, 5000u, 200000u), 'n');
    const TemporaryFolder folder;
    makeFile(folder / "a", std::string(9000, 'o'));
    fs::create_hard_link(folder / "a", folder / "b");
    requireWritable(folder / "a");
    CHECK(contentOf(folder / "b") == std::string(9000, 'o'));
    writeFile(folder / "a", content);
    CHECK((contentOf(folder / "a") == content && contentOf(folder / "b") == content));
    CHECK(fs::hard_link_count(folder / "a") == 2);
    CHECK(folder.count() == 2);
}

TEST_CASE("a file that may not be written is refused beforehand and stays") {
    const TemporaryFolder folder;
    fs::permissions(folder.path, fs::perms::all);
    makeFile(folder / "a", "old");
    fs::permissions(folder / "a", fs::perms(0444));
    const AsNobody nobody;
    CHECK(errorOfBoth(folder / "a") ==
          (folder / "a").string() + ": cannot write: Permission denied");
    CHECK(contentOf(folder / "a") == "old");
    CHECK(folder.count() == 1);
}

TEST_CASE("in a sticky folder the file of another user is only written if it may be") {
    if (geteuid() != 0) return;  // it takes two users
    const TemporaryFolder folder;
    fs::permissions(folder.path, fs::perms(01777));
    for (const unsigned mode : {0644u, 0666u}) {
        const fs::path file = folder / std::to_string(mode);
        makeFile(file, "old");
        fs::permissions(file, fs::perms(mode));
        {
            const AsNobody nobody;
            if (mode == 0644)
                CHECK(errorOfBoth(file) == file.string() + ": cannot write: Permission denied");
            else
                CHECK(errorOfBoth(file).empty());
        }
        CHECK(contentOf(file) == (mode == 0644 ? "old" : "new"));
        CHECK(fs::hard_link_count(file) == 1);
    }
    CHECK(folder.count() == 2);
}

TEST_CASE("a writable file in a folder that is not gets new content") {
    const TemporaryFolder folder;
    makeFile(folder / "a", "old content");
    fs::permissions(folder / "a", fs::perms(0666));
    fs::permissions(folder.path, fs::perms(0555));
    {
        const AsNobody nobody;
        CHECK(errorOfBoth(folder / "a").empty());
        CHECK(has(errorOfBoth(folder / "b"), "cannot write: Permission denied"));
    }
    CHECK(contentOf(folder / "a") == "new");
    CHECK(folder.count() == 1);
    fs::permissions(folder.path, fs::perms::owner_all);
}

TEST_CASE("a device that may not be written is refused beforehand") {
    const TemporaryFolder folder;
    fs::permissions(folder.path, fs::perms::all);
    REQUIRE(mkfifo((folder / "pipe").c_str(), 0444) == 0);
    const AsNobody nobody;
    CHECK(errorOf([&] { requireWritable(folder / "pipe"); }) ==
          (folder / "pipe").string() + ": cannot write: Permission denied");
}

TEST_CASE("no room at all is found beforehand") {
    const TemporaryFolder folder;
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit none = before;
    none.rlim_cur = 0;
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &none);
    const std::string error = errorOf([&] { requireWritable(folder / "a"); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    CHECK(error == (folder / "a").string() + ": cannot write: File too large");
    CHECK(folder.count() == 0);
}

TEST_CASE("a circle of symbolic links is an error") {
    const TemporaryFolder folder;
    fs::create_symlink("b", folder / "a");
    fs::create_symlink("a", folder / "b");
    CHECK(startsWith(errorOfBoth(folder / "a"), (folder / "a").string() + ": cannot write: "));
    CHECK(folder.count() == 2);
}

#endif
