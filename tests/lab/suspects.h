#pragma once

#include <algorithm>
#include <functional>

#include "lab/mirrors.h"

/// How a mistake is told from what came out: by what it would have yielded.
namespace lab {

/// A mistake, what it yields in a case, and what to say about it.
template <typename Case>
struct Suspect {
    std::function<sw::Vec3(const Case&)> yields;
    std::string hint;
};

/// As alike(), for values of any size.
inline bool agree(const sw::Vec3& got, const sw::Vec3& expected) {
    return alike(got, expected, 1e-4f * (1 + expected.norm()));
}

/// The suspect that yields in every case what came out there.
/// @param got  what came out in a case
/// @return     null if there is none, or if two of them do and ask for different hints
template <typename Case, typename Got>
const Suspect<Case>* culprit(const std::vector<Case>& cases, const Got& got,
                             const std::vector<Suspect<Case>>& suspects) {
    const Suspect<Case>* found = nullptr;
    for (const Suspect<Case>& suspect : suspects) {
        const bool guilty = std::all_of(cases.begin(), cases.end(), [&](const Case& c) {
            return agree(got(c), suspect.yields(c));
        });
        if (!guilty) continue;
        if (found != nullptr && found->hint != suspect.hint) return nullptr;
        found = &suspect;
    }
    return found;
}

/// What is returned is one of the vector's: a temporary vector would not do.
template <typename Case, typename Got>
const Suspect<Case>* culprit(const std::vector<Case>&, const Got&,
                             const std::vector<Suspect<Case>>&&) = delete;

/// Directions are compared without their length: that is the business of a test of its own.
inline sw::Vec3 heading(const sw::Vec3& direction) {
    return unit(direction);
}

/// What some of many cases are said to suffer from: a hint if it is the same for all of them.
class Verdict {
public:
    void add(const std::string& hint) {
        all = count == 0 || all == hint ? hint : "";
        ++count;
    }
    int wrong() const { return count; }
    const std::string& hint() const { return all; }

private:
    int count = 0;
    std::string all;
};

}  // namespace lab
