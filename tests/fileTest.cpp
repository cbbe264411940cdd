#include "swFile.h"

#include <atomic>
#include <csignal>
#include <thread>

#include "files.h"
#include "support.h"

#if __has_include(<sys/resource.h>)
#define SW_TEST_POSIX 1
#include <sys/resource.h>
#else
#define SW_TEST_POSIX 0
#endif

using namespace sw;
using namespace test;

TEST_CASE("what is written is read back byte for byte") {
    Random random(GENERATE(range(0u, 20u)));
    std::string content(static_cast<std::size_t>(random.magnitude(1, 1e6)) - 1, '\0');
    for (char& byte : content) byte = static_cast<char>(random.whole(-128, 127));
    CAPTURE(content.size());
    const TemporaryFolder folder;
    writeFile(folder / "a", content);
    CHECK((contentOf(folder / "a") == content));
    CHECK((readFile(folder / "a") == content));
    CHECK(folder.count() == 1);
}

TEST_CASE("an existing file is replaced whole") {
    const TemporaryFolder folder;
    makeFile(folder / "a", std::string(100000, 'x'));
    writeFile(folder / "a", "new");
    CHECK(contentOf(folder / "a") == "new");
    CHECK(folder.count() == 1);
}

TEST_CASE("a name without a folder is a file in the current one") {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path);
    writeFile("plain.txt", "here");
    const std::string content = readFile("plain.txt");
    fs::current_path(before);
    CHECK(content == "here");
    CHECK(contentOf(folder / "plain.txt") == "here");
}

#if SW_TEST_POSIX  // on Windows, a file that a reader has open gets new content in its place
TEST_CASE("readers never see half a file") {
    const TemporaryFolder folder;
    const fs::path path = folder / "a";
    const std::string contents[] = {std::string(1 << 20, 'a'), std::string(1 << 19, 'b')};
    writeFile(path, contents[0]);
    std::atomic<bool> done = false;
    std::atomic<int> torn = 0, reads = 0;
    std::thread reader([&] {
        while (!done || reads == 0) {
            const std::string seen = contentOf(path);
            if (seen != contents[0] && seen != contents[1]) ++torn;
            ++reads;
        }
    });
    for (int i = 0; i < 100; ++i) writeFile(path, contents[i % 2]);
    done = true;
    reader.join();
    INFO(reads << " reads");
    CHECK(torn == 0);
}
#endif

TEST_CASE("a missing folder is an error that names it") {
    const TemporaryFolder folder;
    const fs::path path = folder / "missing/a";
    const std::string expected = path.string() + ": cannot write: there is no folder " +
                                 (folder / "missing").string() + "; create it or name another";
    CHECK(errorOf([&] { writeFile(path, "x"); }) == expected);
    CHECK(errorOf([&] { requireWritable(path); }) == expected);
    CHECK(folder.count() == 0);
}

TEST_CASE("a file in place of a folder is an error") {
    const TemporaryFolder folder;
    makeFile(folder / "file", "x");
    const fs::path path = folder / "file/a";
    CHECK(startsWith(errorOf([&] { writeFile(path, "x"); }), path.string() + ": cannot write: "));
    CHECK(startsWith(errorOf([&] { requireWritable(path); }), path.string() + ": cannot write: "));
}

TEST_CASE("a folder cannot be written as a file") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    for (const std::string name : {"sub", "sub/", "missing/", "."}) {
        const std::string expected =
            (folder / name).string() + ": is a folder; expected the name of a file";
        CAPTURE(name);
        CHECK(errorOf([&] { writeFile(folder / name, "x"); }) == expected);
        CHECK(errorOf([&] { requireWritable(folder / name); }) == expected);
    }
    CHECK(folder.count() == 1);
    CHECK(fs::is_empty(folder / "sub"));
}

TEST_CASE("an empty name is an error like any other") {
    CHECK_THROWS_AS(writeFile("", "x"), FileError);
    CHECK_THROWS_AS(requireWritable(""), FileError);
    CHECK_THROWS_AS(readFile(""), FileError);
}

TEST_CASE("asking whether a file can be written changes nothing") {
    const TemporaryFolder folder;
    requireWritable(folder / "new");
    CHECK(folder.count() == 0);
    makeFile(folder / "old", "kept");
    requireWritable(folder / "old");
    CHECK(contentOf(folder / "old") == "kept");
    CHECK(folder.count() == 1);
}

TEST_CASE("a file that cannot be read is an error that names it") {
    const TemporaryFolder folder;
    CHECK(errorOf([&] { readFile(folder / "none"); }) ==
          (folder / "none").string() + ": not found; is the path right?");
    CHECK(errorOf([&] { readFile(folder.path); }) ==
          folder.path.string() + ": is a folder; expected a file");
}

#if SW_TEST_POSIX

TEST_CASE("a reader that has the old file open keeps it") {
    const TemporaryFolder folder;
    makeFile(folder / "a", "old content");
    std::ifstream opened(folder / "a");
    writeFile(folder / "a", "new");
    std::string line;
    std::getline(opened, line);
    CHECK(line == "old content");
}

TEST_CASE("a failure while writing leaves the old file and nothing else") {
    const auto size = GENERATE(1010, 100000);  // the first fails only when its buffer is emptied
    CAPTURE(size);
    const TemporaryFolder folder;
    makeFile(folder / "a", "old");
    // No file may grow beyond 1000 bytes: a full disk in miniature.
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 1000;
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error =
        errorOf([&] { writeFile(folder / "a", std::string(static_cast<std::size_t>(size), 'x')); });
    const std::string fits = errorOf([&] { writeFile(folder / "b", std::string(999, 'x')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);

    CHECK(startsWith(error, (folder / "a").string() + ": cannot write: "));
    CHECK(fits.empty());
    CHECK(contentOf(folder / "a") == "old");
    CHECK(folder.count() == 2);
}

TEST_CASE("a folder without write permission is an error") {
    const TemporaryFolder folder;
    fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
    const bool allMighty = static_cast<bool>(std::ofstream(folder / "probe"));  // root
    if (!allMighty) {
        const std::string expected = (folder / "a").string() + ": cannot write: Permission denied";
        CHECK(errorOf([&] { writeFile(folder / "a", "x"); }) == expected);
        CHECK(errorOf([&] { requireWritable(folder / "a"); }) == expected);
    }
    fs::permissions(folder.path, fs::perms::owner_all);
}

#endif
