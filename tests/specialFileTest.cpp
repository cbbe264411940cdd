// Devices, pipes and links: what the file system holds beside files. Windows has no names for the
// first two in folders, and lets only administrators make links.
#ifndef _WIN32

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/sysmacros.h>
#endif

#include <algorithm>

#include "files.h"
#include "support.h"

using namespace sw;
using namespace test;

#ifdef __linux__
TEST_CASE("a device without an end is no file to read, by name or as standard input") {
    for (const char* device : {"/dev/zero", "/dev/full", "/dev/urandom"})
        if (fs::exists(device))
            CHECK(errorOf([=] { readFile(device); }) ==
                  std::string(device) + ": is a device; expected a file");
}

TEST_CASE("a full device is an error with its reason") {
    // Our own device, never /dev/full: run by root, a library that replaces special files would
    // destroy the machine's. A user who may not create devices cannot rename in /dev either.
    const TemporaryFolder folder;
    const bool own = mknod((folder / "full").c_str(), S_IFCHR | 0666, makedev(1, 7)) == 0;
    if (!own && access("/dev", W_OK) == 0) return;
    const fs::path full = own ? folder / "full" : fs::path("/dev/full");
    if (!std::ofstream(full)) return;  // devices do not work here
    CHECK(errorOf([&] { writeFile(full, "x"); }) ==
          full.string() + ": cannot write: No space left on device");
    CHECK(fs::is_character_file(full));
}
#endif

TEST_CASE("a device that cannot be read is an error") {
    // It opens, but reading the first byte fails.
    if (!fs::exists("/proc/self/mem")) return;
    CHECK(startsWith(errorOf([] { readFile("/proc/self/mem"); }), "/proc/self/mem: cannot read: "));
}

TEST_CASE("special files are written to and stay what they are") {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    requireWritable(pipe);  // neither waits for a reader nor makes a file
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    REQUIRE(reader >= 0);
    writeFile(pipe, "through the pipe");
    char received[100];
    const auto length = read(reader, received, sizeof received);
    close(reader);
    CHECK(std::string(received, static_cast<std::size_t>(std::max<long>(length, 0))) ==
          "through the pipe");
    CHECK(fs::is_fifo(pipe));
    CHECK(folder.count() == 1);
}

TEST_CASE("a symbolic link stays one and its target is replaced") {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    makeFile(folder / "sub/real", "old");
    fs::create_symlink("sub/real", folder / "link");
    fs::create_symlink("link", folder / "chain");
    writeFile(folder / "chain", "new");
    CHECK(contentOf(folder / "sub/real") == "new");
    CHECK((fs::is_symlink(folder / "link") && fs::is_symlink(folder / "chain")));
    CHECK(folder.count() == 3);
}

TEST_CASE("a symbolic link to a file that does not exist yet makes that file") {
    const TemporaryFolder folder;
    fs::create_symlink("later", folder / "link");
    writeFile(folder / "link", "new");
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(contentOf(folder / "later") == "new");
}

#endif
