// Names of open streams: what is written to them comes behind what they hold.
#ifndef _WIN32  // numbers of streams as names

#include <fcntl.h>
#include <unistd.h>

#include <string>
#include <thread>

#include "files.h"
#include "files/target.h"
#include "support.h"

using namespace sw;
using namespace test;

namespace {

// An open file, closed at the end.
struct Stream {
    Stream(const fs::path& file, int flags) : number(open(file.c_str(), flags, 0600)) {}
    ~Stream() { close(number); }
    const int number;
};

std::vector<std::string> namesOf(int stream) {
    std::vector<std::string> names{"/dev/fd/" + std::to_string(stream)};
    if (fs::exists("/proc/self/fd")) {
        names.push_back("/proc/self/fd/" + std::to_string(stream));
        names.push_back("/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(stream));
    }
    return names;
}

}  // namespace

TEST_CASE("a stream is written to where it stands, by all its names") {
    const TemporaryFolder folder;
    makeFile(folder / "log", "before ");
    const Stream stream(folder / "log", O_WRONLY | O_APPEND);
    std::string expected = "before ";
    std::vector<std::string> names = namesOf(stream.number);
    fs::create_symlink(names[0], folder / "link");
    names.push_back((folder / "link").string());
    for (const std::string& name : names) {
        CAPTURE(name);
        CHECK(targetOf(name).stream == stream.number);
        CHECK(errorOf([&] { requireWritable(name); }).empty());
        writeFile(name, name + " ");
        CHECK(contentOf(folder / "log") == (expected += name + " "));
    }
    CHECK(folder.count() == 2);
}

TEST_CASE("files and streams of other processes are no streams") {
    const TemporaryFolder folder;
    const Stream stream(folder / "a", O_RDWR | O_CREAT);
    for (const std::string& name :
         {(folder / "a").string(), std::string("/dev/null"), std::string("1"),
          std::string("/proc/1/fd/1"), (folder / "fd/1").string()})
        CHECK_FALSE(targetOf(name).stream);
}

TEST_CASE("a stream that is closed or only read is refused beforehand") {
    const TemporaryFolder folder;
    makeFile(folder / "a", "content");
    const Stream stream(folder / "a", O_RDONLY);
    std::vector<std::string> names = namesOf(stream.number);
    for (const std::string& name : namesOf(987)) names.push_back(name);
    for (const std::string& name : names) {
        CHECK(errorOf([&] { requireWritable(name); }) ==
              name + ": cannot write: it is closed, or open for reading only");
        CHECK(startsWith(errorOf([&] { writeFile(name, "x"); }), name + ": cannot write: "));
    }
    CHECK(contentOf(folder / "a") == "content");
}

TEST_CASE("a pipe that is full for a while gets every byte") {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    REQUIRE(fcntl(ends[1], F_SETFL, O_NONBLOCK) == 0);
    std::string content(3'000'000, ' '), received;
    for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>(i * i >> 7);
    std::thread reader([&] {
        char part[5000];
        for (ssize_t n; (n = read(ends[0], part, sizeof part)) > 0;)
            received.append(part, static_cast<std::size_t>(n));
    });
    const std::string name = "/dev/fd/" + std::to_string(ends[1]);
    const std::string error = errorOf([&] { writeFile(name, content); });
    close(ends[1]);
    reader.join();
    close(ends[0]);
    CHECK(error.empty());
    CHECK((received == content));
}

#endif
