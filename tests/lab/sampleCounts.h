#pragma once

#include "lab/samples.h"

/// How many samples the student's samplePixel() takes, and which mistake takes so many.
namespace lab {

struct Count {
    int n;
    Pixel pixel;
};

inline std::size_t found(const Count& count) {
    return count.pixel.samples.size();
}

/// For many n: also those for which a sum of rounded steps 1 / n ends below 1. As far as there is
/// no end of the samples three times.
inline const std::vector<Count>& counts() {
    static const std::vector<Count> all = [] {
        std::vector<Count> some;
        int endless = 0;
        for (const int n : {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 19, 23})
            for (const auto& [x, y] : {std::pair(0, 0), {3, 1}, {2, 3}}) {
                if (endless == 3) continue;
                sw::seedPixel(5, n, x);
                some.push_back({n, pixelOf(skyScene(), x, y, n)});
                endless += some.back().pixel.endless;
            }
        return some;
    }();
    return all;
}

template <typename Is>
bool allCounts(Is is) {
    return std::all_of(counts().begin(), counts().end(), is);
}

/// Rounds of a loop that adds up steps of 1 / n from `from` to `from + 1`.
template <typename Number, typename Step>
int roundsOf(int n, Number from) {
    const Step step = 1 / static_cast<Step>(n);
    int rounds = 0;
    for (Number s = from; s < from + 1; s = static_cast<Number>(s + step)) ++rounds;
    return rounds;
}

/// Whether a loop in steps of 1 / n explains all counts.
template <typename Number, typename Step>
bool isLoopInSteps(bool fromCorner) {
    const auto rounds = [&](int n, int corner) {
        return roundsOf<Number, Step>(n, fromCorner ? static_cast<Number>(corner) : Number(0));
    };
    return allCounts([&](const Count& c) {
        return static_cast<int>(found(c)) == rounds(c.n, c.pixel.x) * rounds(c.n, c.pixel.y);
    });
}

inline std::string stepsHint() {
    for (const bool fromCorner : {false, true}) {
        if (!isLoopInSteps<float, float>(fromCorner) && !isLoopInSteps<float, double>(fromCorner) &&
            !isLoopInSteps<double, double>(fromCorner) && !isLoopInSteps<double, float>(fromCorner))
            continue;
        for (const Count& c : counts())
            if (static_cast<int>(found(c)) > c.n * c.n)
                return "one row or column too many at n = " + std::to_string(c.n) +
                       ": 1.0f / n is rounded, so that " + std::to_string(c.n) +
                       " such steps end just short of 1, where whole numbers count exactly";
    }
    return "";
}

/// A number of samples that a mistake takes, and what to say about it.
struct CountGuess {
    int (*wrong)(int n);
    const char* hint;
};

inline int square(float side) {
    return static_cast<int>(side * side + 0.5f);
}

inline std::string numberHint() {
    static const char* const total =
        "n is the number of cells along each side of the pixel, not the number of all samples";
    static const char* const counters =
        "a counter that runs from 0 to n - 1 makes n rounds, one for each row or column";
    const std::initializer_list<CountGuess> guesses{
        {[](int n) { return n; }, "n samples in all, but n rows of n cells each need n * n"},
        {[](int n) { return 2 * n; }, "n + n samples in all, but n rows of n cells need n * n"},
        {[](int n) { return square(std::floor(std::sqrt(static_cast<float>(n)))); }, total},
        {[](int n) { return square(std::round(std::sqrt(static_cast<float>(n)))); }, total},
        {[](int n) { return square(std::ceil(std::sqrt(static_cast<float>(n)))); }, total},
        {[](int n) { return (n + 1) * (n + 1); }, counters},
        {[](int n) { return (n - 1) * (n - 1); }, counters},
        {[](int n) { return n * (n + 1); }, counters},
        {[](int n) { return n * (n - 1); }, counters},
        {[](int n) { return n * n + 1; },
         "one sample more than there are cells: each cell needs one, and nothing else does"},
        {[](int n) { return n * n * n; }, "n samples for each cell, where one is enough"},
        {[](int n) { return n * n * n * n; }, "n * n samples for each cell, where one is enough"}};
    // n = 1 may be a case of its own.
    const auto explains = [](const CountGuess& guess, const Count& c) {
        const int got = static_cast<int>(found(c));
        return !c.pixel.endless && (got == guess.wrong(c.n) || (got == 1 && c.n == 1));
    };
    for (const CountGuess& guess : guesses)
        if (allCounts([&](const Count& c) { return explains(guess, c); })) return guess.hint;
    return "";
}

inline bool isInFirstCell(const Sample& s, int n) {
    const float end = 1 / static_cast<float>(n) + rounding;
    return s.x < end && s.y < end;
}

/// No end, but for n = 1, and all in the first cell.
inline bool stepIsZero() {
    return counts().back().n > 1 && allCounts([](const Count& c) {
               const auto& samples = c.pixel.samples;
               return c.pixel.endless == (c.n > 1) &&
                      std::all_of(samples.begin(), samples.end(),
                                  [&](const Sample& s) { return isInFirstCell(s, c.n); });
           });
}

/// One sample for any n.
inline std::string singleHint() {
    const auto isCentre = [](const Sample& s) {
        return std::fabs(s.x - 0.5f) + std::fabs(s.y - 0.5f) < rounding;
    };
    const std::size_t rays = counts()[0].pixel.rays.size();
    if (!allCounts([&](const Count& c) { return c.pixel.rays.size() == rays; }))
        return "";  // many rays through one point
    if (allCounts([&](const Count& c) { return isCentre(c.pixel.samples[0]); }))
        return "samplePixel() in main.cpp takes a single sample, as the starter does: this is "
               "where task 6 begins";
    if (allCounts([](const Count& c) { return isInFirstCell(c.pixel.samples[0], c.n); }))
        return "a single sample, in the first cell, whatever n is: samplePixel() may return only "
               "after all rounds of its loops";
    return "a single sample whatever n is: each of the n * n cells needs one";
}

/// The known mistake that explains all counts; empty if there is none.
inline std::string countHint() {
    if (allCounts([](const Count& c) { return found(c) == 1 && !c.pixel.endless; }))
        return singleHint();
    if (stepIsZero())
        return "the loop never gets beyond the first cell: 1 / n in whole numbers is 0, unless n "
               "is 1";
    if (found(counts()[0]) > 1 && allCounts([](const Count& c) {
            return !c.pixel.endless && found(c) == found(counts()[0]);
        }))
        return "the number of samples is the same for every n";
    const std::string hint = numberHint();
    return hint.empty() ? stepsHint() : hint;
}

}  // namespace lab
