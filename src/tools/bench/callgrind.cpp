#include "tools/bench/callgrind.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace bench {
namespace {

// Takes callgrind's output line by line: https://valgrind.org/docs/manual/cl-format.html
class Counter {
public:
    std::vector<std::uint64_t> counts;  // by part; the last one is for none

    explicit Counter(const std::vector<ProgramPart>& known)
        : counts(known.size() + 1), parts(known) {}

    void take(const std::string& line) {
        const auto equals = line.find('=');
        const std::string word = line.substr(0, std::min<std::size_t>(equals, line.size()));
        if (word == "fn") {
            startFunction();
        } else if (word == "calls") {
            isCall = true;
        } else if (word == "fl" || word == "fi" || word == "fe" || word == "cfi" || word == "cfl") {
            const std::optional<std::size_t> part = partOf(line.substr(equals + 1));
            if (word == "fl") ofFunction = part;
            if (part && (word == "fi" || word == "fe")) enter(*part);
        } else if (!line.empty() && line.find_first_of("0123456789+-*") == 0) {
            takeCost(line);
        } else if (line.starts_with("summary: ")) {
            total = std::stoull(line.substr(9));
        }
    }

    void finish() {
        startFunction();
        const auto sum = std::accumulate(counts.begin(), counts.end(), std::uint64_t{});
        if (sum != total)
            throw std::runtime_error("callgrind's output: the lines add up to " +
                                     std::to_string(sum) + " instructions, the summary says " +
                                     std::to_string(total));
    }

private:
    void startFunction() {
        counts.back() += ofNone;
        ofNone = 0;
        current = ofFunction;
    }

    void enter(std::size_t part) {
        current = part;
        counts[part] += ofNone;  // the function began with lines of no part
        ofNone = 0;
    }

    // "+3 120": three lines further down, 120 instructions. After a call: those of the function
    // called, which has lines of its own.
    void takeCost(const std::string& line) {
        std::istringstream text(line);
        std::string place;
        std::uint64_t cost = 0;
        text >> place >> cost;
        if (!isCall) (current ? counts[*current] : ofNone) += cost;
        isCall = false;
    }

    // Files are "(7) name" at first and "(7)" from then on.
    std::optional<std::size_t> partOf(const std::string& file) {
        const auto end = file.find(')');
        const std::string number = file.substr(0, end);
        const auto [known, isNew] = partsOfFiles.try_emplace(number);
        if (!isNew) return known->second;
        for (std::size_t i = 0; i < parts.size() && !known->second; ++i)
            for (const std::string& name : parts[i].files)
                if (file.find(name) != std::string::npos) known->second = i;
        return known->second;
    }

    const std::vector<ProgramPart>& parts;
    std::map<std::string, std::optional<std::size_t>> partsOfFiles;
    std::optional<std::size_t> ofFunction, current;
    std::uint64_t ofNone = 0, total = 0;
    bool isCall = false;
};

}  // namespace

std::vector<std::uint64_t> instructionsByPart(std::istream& profile,
                                              const std::vector<ProgramPart>& parts) {
    Counter counter(parts);
    for (std::string line; std::getline(profile, line);) counter.take(line);
    counter.finish();
    return counter.counts;
}

}  // namespace bench
