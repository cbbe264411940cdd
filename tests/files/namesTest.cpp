// Names of files beyond ASCII, and files that are in use.
#include "files.h"
#include "files/windowsApi.h"
#include "support.h"

using namespace sw;
using namespace test;

TEST_CASE("a file with a name in any script is written, read and found by that name") {
    const TemporaryFolder folder;
    const std::vector<fs::path> names = {u8"gr\u00f6\u00dfe.png", u8"\u66f8\u985e",
                                         u8"\u0441\u0446\u0435\u043d\u0430.nff",
                                         u8"\U0001f4d0 \u00e9", u8"e\u0301.png"};
    for (const fs::path& name : names) {
        CAPTURE(name);
        requireWritable(folder.path / name);
        CHECK(folder.count() == 0);
        writeFile(folder.path / name, "first");
        writeFile(folder.path / name, "second");
        CHECK(readFile(folder.path / name) == "second");
        CHECK(contentOf(folder.path / name) == "second");
        REQUIRE(folder.count() == 1);
        CHECK(fs::directory_iterator(folder.path)->path().filename() == name);
        fs::remove(folder.path / name);
    }
}

TEST_CASE("a path of many folders with long names works") {
    const TemporaryFolder folder;
    fs::path deep = folder.path;
    for (int i = 0; i < 3; ++i) deep /= std::string(60, static_cast<char>('a' + i));
    fs::create_directories(deep);
    requireWritable(deep / "a");
    writeFile(deep / "a", "content");
    CHECK(readFile(deep / "a") == "content");
}

#ifdef _WIN32
TEST_CASE("a file that another program has open is noticed before the work and stays as it is") {
    const TemporaryFolder folder;
    makeFile(folder / "a.png", "old");
    const DWORD sharing = GENERATE(0, FILE_SHARE_READ);
    const HANDLE file = CreateFileW((folder / "a.png").c_str(), GENERIC_READ, sharing, nullptr,
                                    OPEN_EXISTING, 0, nullptr);
    REQUIRE(file != INVALID_HANDLE_VALUE);
    const std::string asked = errorOf([&] { requireWritable(folder / "a.png"); });
    const std::string written = errorOf([&] { writeFile(folder / "a.png", "new"); });
    CloseHandle(file);
    CHECK(asked == (folder / "a.png").string() +
                       ": cannot write: another program has it open; "
                       "close it there, or name another file");
    CHECK(startsWith(written, (folder / "a.png").string() + ": cannot write: "));
    CHECK(contentOf(folder / "a.png") == "old");
    CHECK(folder.count() == 1);
    writeFile(folder / "a.png", "new");
    CHECK(contentOf(folder / "a.png") == "new");
}
#endif
