#pragma once

#include <algorithm>
#include <cstdlib>
#include <string>

#include "catch.h"
#include "files.h"
#include "png.h"

#ifndef _WIN32
#include <sys/wait.h>
#endif

namespace test {

/// What a run of the program left behind.
struct Run {
    int code;              ///< exit code; -1 if it crashed
    std::string out, err;  ///< what it printed
};

/// A path as a word of the command line. On Windows with its drive, as the folder that it is used
/// in may lie on another one.
inline std::string quoted(const fs::path& path) {
    const fs::path whole = path.has_root_directory() ? fs::absolute(path) : path;
    return std::string("\"").append(fs::path(whole).make_preferred().string()).append("\"");
}

inline int lines(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// What a program printed. Windows ends a line of text by two characters.
inline std::string printedIn(const fs::path& file) {
    std::string text = contentOf(file);
#ifdef _WIN32
    if (has(text, std::string(1, '\0'))) return text;  // a picture
    for (std::size_t at = 0; (at = text.find("\r\n", at)) != std::string::npos; ++at)
        text.erase(at, 1);
#endif
    return text;
}

/// Runs a program in a folder.
/// @param before  shell commands that come first, each with its separator: "ulimit -f 1; "
inline Run runProgram(const fs::path& program, const TemporaryFolder& folder,
                      const std::string& arguments, const std::string& before = "") {
    const TemporaryFolder printed;
#ifdef _WIN32
    const std::string enter = "cd /d ";
#else
    const std::string enter = "cd ";
#endif
    std::string command = enter + quoted(folder.path) + " && " + before + quoted(program) + " " +
                          arguments + " >" + quoted(printed / "out") + " 2>" +
                          quoted(printed / "err");
#ifdef _WIN32
    const int code = std::system(("\"" + command + "\"").c_str());
#else
    const int status = std::system(command.c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
#endif
    return {code, printedIn(printed / "out"), printedIn(printed / "err")};
}

/// The program swtracer.
inline Run swtracer(const TemporaryFolder& folder, const std::string& arguments,
                    const std::string& before = "") {
    return runProgram(SW_PROGRAM, folder, arguments, before);
}

/// The picture that these arguments make.
inline std::string picture(const std::string& arguments) {
    const TemporaryFolder folder;
    const Run run = swtracer(folder, arguments + " -o a.png");
    CAPTURE(arguments, run.err);
    CHECK(run.code == 0);
    return contentOf(folder / "a.png");
}

/// The number behind "key": in JSON.
inline double numberOf(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\": ");
    CAPTURE(json, key);
    REQUIRE(at != std::string::npos);
    return std::strtod(json.c_str() + at + key.size() + 4, nullptr);
}

/// The statistics, as JSON.
inline std::string statsOf(const std::string& arguments) {
    const TemporaryFolder folder;
    CHECK(swtracer(folder, arguments + " --stats s.json").code == 0);
    return contentOf(folder / "s.json");
}

}  // namespace test
