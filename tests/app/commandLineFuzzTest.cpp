// Random command lines, the same in every run: 500 of them, or as many as SWTRACER_FUZZ_RUNS says.
#ifndef _WIN32  // POSIX: fork(), signals, links

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "app/commandLines.h"
#include "app/programRun.h"

using namespace test;

namespace {

struct Streams {
    std::string in, out;  // names of files; empty: closed
};

struct Ended {
    int code;  // -1 for a signal
    std::string err;
};

void redirect(int stream, const std::string& file, int flags) {
    close(stream);
    if (!file.empty() && open(file.c_str(), flags, 0600) != stream) _exit(97);
}

// Runs the program in a folder; a run that takes longer than 20 s is ended by a signal.
Ended start(const fs::path& folder, const std::vector<std::string>& arguments,
            const Streams& streams, const fs::path& errors) {
    std::vector<char*> words{const_cast<char*>("swtracer")};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        redirect(0, streams.in, O_RDONLY);
        redirect(2, errors.string(), O_WRONLY | O_CREAT | O_TRUNC);
        redirect(1, streams.out, O_WRONLY);
        if (chdir(folder.c_str()) != 0) _exit(98);
        setenv("TMPDIR", folder.c_str(), 1);
        alarm(20);
        execv(SW_PROGRAM, words.data());
        _exit(99);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(errors)};
}

// Everything in a folder: kind, mode and content by name.
std::map<std::string, std::string> snapshot(const fs::path& folder) {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const fs::file_status status = entry.symlink_status();
        std::string text = std::to_string(static_cast<int>(status.type())) + " " +
                           std::to_string(static_cast<unsigned>(status.permissions())) + " ";
        if (fs::is_regular_file(status)) text += contentOf(entry.path());
        if (fs::is_symlink(status)) text += fs::read_symlink(entry.path()).string();
        all[entry.path().lexically_relative(folder).string()] = text;
    }
    return all;
}

// Whether a file is all that it began as: a picture or statistics.
bool isWhole(const std::string& content) {
    if (startsWith(content, "{\n")) return content.substr(content.size() - 3) == "\n}\n";
    if (startsWith(content, "PF\n")) return content.size() >= 24;
    if (startsWith(content, "#?RADIANCE\n")) return content.size() > 60;
    try {
        PngStructure structure(content);
    } catch (const std::exception&) {
        return false;
    }
    return true;
}

// Lines of stderr that are neither warnings nor the summary of a run that went well.
int errorLines(const std::string& err) {
    int count = 0;
    std::istringstream in(err);
    for (std::string line; std::getline(in, line);)
        count += startsWith(line, "swtracer: ") && !has(line, ": warning: ") ? 1 : 0;
    return count;
}

bool startsEveryLine(const std::string& err, const std::string& start) {
    std::istringstream in(err);
    for (std::string line; std::getline(in, line);)
        if (!startsWith(line, start)) return false;
    return err.empty() || err.back() == '\n';
}

void checkEnd(const Ended& run) {
    CHECK((run.code == 0 || run.code == 2 || run.code == 3 || run.code == 4));
    CHECK(errorLines(run.err) == (run.code == 0 ? 0 : 1));
    if (run.code != 0) CHECK(startsEveryLine(run.err, "swtracer: "));
}

// Only whole outputs may differ, and nothing at all after an error before the output.
// Notes and scenes are never replaced unless by force.
bool checkFolder(const fs::path& folder, const std::map<std::string, std::string>& before, int code,
                 bool force) {
    const auto after = snapshot(folder);
    for (const auto& [name, text] : before) {
        CAPTURE(name);
        CHECK(after.count(name) == 1);
    }
    for (const auto& [name, text] : after) {
        const auto old = before.find(name);
        if (old != before.end() && old->second == text) continue;
        CAPTURE(name);
        CHECK((code == 0 || code == 4));
        CHECK(isWhole(contentOf(folder / name)));
        const bool ofOurs = old == before.end() || name == "picture.png" || name == "stats.json" ||
                            name == "empty.png";
        CHECK((force || ofOurs));
        CHECK_FALSE(has(name, "swtracer-"));
    }
    return after == before;
}

}  // namespace

TEST_CASE("no command line crashes, leaves half a file, or touches what is not an output") {
    const char* const wanted = std::getenv("SWTRACER_FUZZ_RUNS");
    const int runs = wanted ? std::atoi(wanted) : 500;
    CommandLines lines(1);
    Random random(2);
    const TemporaryFolder place;
    std::map<int, int> ends;
    std::map<std::string, std::string> before;
    bool unchanged = false;
    for (int i = 0; i < runs; ++i) {
        const fs::path folder = place / "here";
        if (!unchanged) {
            fs::remove_all(folder);
            fs::create_directory(folder);
            furnish(folder);
            before = snapshot(folder);
        }
        makeFile(place / "out", "");
        const std::string outs[] = {(place / "out").string(), "/dev/null", "/dev/full", ""};
        const Streams streams{random.coin() ? "/dev/null" : (folder / "scene.nff").string(),
                              outs[random.whole(0, 9) < 8 ? 0 : random.whole(1, 3)]};
        const std::vector<std::string> arguments = lines.next();
        std::string line;
        bool force = false;
        for (const std::string& word : arguments) {
            line += "'" + word + "' ";
            force = force || word == "--force";
        }
        const Ended run = start(folder, arguments, streams, place / "err");
        CAPTURE(i, line, streams.in, streams.out, run.code, run.err);
        checkEnd(run);
        unchanged = checkFolder(folder, before, run.code, force);
        ++ends[run.code];
    }
    CAPTURE(ends[0], ends[2], ends[3], ends[4]);
    if (runs >= 500) CHECK((ends[0] > 20 && ends[2] > 20 && ends[3] > 20 && ends[4] > 5));
}

#endif
