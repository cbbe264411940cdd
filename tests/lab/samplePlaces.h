#pragma once

#include "lab/samples.h"

/// What is wrong with the places of samples.
namespace lab {

inline bool inFirstCell(const Sample& s, int n) {
    const float end = 1 / static_cast<float>(n) + rounding;
    return s.x < end && s.y < end;
}

inline bool leavesPixel(const Sample& s) {
    const float low = -rounding, high = 1 + rounding;
    return !(s.x >= low && s.x <= high && s.y >= low && s.y <= high);
}

// Whether two parts of a cell are the same; the end of one cell is the beginning of the next.
inline bool samePart(float a, float b) {
    const float apart = std::fabs(a - b);
    return std::min(apart, 1 - apart) < 0.001f;
}

inline std::string countHint(const Samples& samples) {
    const int n = samples.n, count = static_cast<int>(samples.pixels[0].size());
    if (count == 1) {
        return "samplePixel() in main.cpp takes a single sample, as the starter does: this is "
               "where task 6 begins";
    }
    if (count == n)
        return "one row or one diagonal of the grid is not all of it: n rows have n "
               "cells each";
    return "one sample for each cell of a grid of n rows and n columns";
}

inline bool wrongCount(const Samples& samples) {
    const auto expected = static_cast<std::size_t>(samples.n * samples.n);
    return std::any_of(samples.pixels.begin(), samples.pixels.end(),
                       [&](const auto& pixel) { return pixel.size() != expected; });
}

// Whether the samples lie at the same places in all pixels.
inline bool isPattern(const Samples& samples) {
    const auto& first = samples.pixels[0];
    for (const auto& pixel : samples.pixels)
        for (std::size_t i = 0; i < pixel.size(); ++i)
            if (std::fabs(pixel[i].x - first[i].x) + std::fabs(pixel[i].y - first[i].y) > 1e-4f)
                return false;
    return true;
}

inline std::string patternHint(const Samples& samples) {
    const auto allAt = [&](float part) {
        return share(samples, [&](const Sample& s) {
                   return samePart(inCell(s.x, samples.n), part) &&
                          samePart(inCell(s.y, samples.n), part);
               }) > 0.99f;
    };
    if (allAt(0.5f))
        return "all samples lie in the centres of their cells: a random number moves "
               "each to some other place in its cell, and turns steps into noise";
    if (allAt(0))
        return "all samples lie in the corners of their cells: a random number moves "
               "each to some place inside";
    return "the samples lie at the same places in every pixel: do the random numbers start anew "
           "each time?";
}

// The fraction of pairs of samples in one pixel that share a random number.
inline float sharedNumbers(const Samples& samples) {
    const int n = samples.n;
    float shared = 0, all = 0;
    for (const auto& pixel : samples.pixels)
        for (std::size_t i = 0; i < pixel.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                ++all;
                shared += samePart(inCell(pixel[i].x, n), inCell(pixel[j].x, n)) ||
                          samePart(inCell(pixel[i].y, n), inCell(pixel[j].y, n));
            }
    return shared / all;
}

inline bool oneNumberForBoth(const Samples& samples) {
    return share(samples, [&](const Sample& s) {
               return samePart(inCell(s.x, samples.n), inCell(s.y, samples.n));
           }) > 0.9f;
}

// The smallest and the largest of some numbers.
struct Range {
    float low = 2, high = -2;
    void add(float x) { low = std::min(low, x), high = std::max(high, x); }
    /// From 0 to 1, as far as chance tells.
    bool isWhole() const { return low < 0.03f && high > 0.97f; }
};

// Where the samples lie along one axis, in the pixel and in their cells.
struct Coverage {
    Range pixel, cell;
    bool isWhole() const { return pixel.isWhole() && cell.isWhole(); }
};

inline Coverage coverage(const Samples& samples, float Sample::*axis) {
    Coverage c;
    for (const auto& pixel : samples.pixels)
        for (const Sample& s : pixel) {
            c.pixel.add(s.*axis);
            c.cell.add(inCell(s.*axis, samples.n));
        }
    return c;
}

// Random numbers that are none, or too few.
inline std::string randomHint(const Samples& samples) {
    if (isPattern(samples)) return patternHint(samples);
    if (oneNumberForBoth(samples)) {
        return "one random number is used for both axes, so all samples lie on the diagonals of "
               "their cells: draw one for x and another one for y";
    }
    if (sharedNumbers(samples) > 0.1f) {
        return "several samples of a pixel share a random number: draw new ones for every sample, "
               "in the innermost loop";
    }
    return "";
}

// Samples that do not reach everywhere.
inline std::string coverageHint(const Samples& samples) {
    for (const auto axis : {&Sample::x, &Sample::y}) {
        const Coverage c = coverage(samples, axis);
        if (c.isWhole()) continue;
        if (c.cell.isWhole()) {
            return "the samples cover only part of the pixel: together the cells fill it from "
                   "edge to edge";
        }
        return "the samples cover only part of each cell: a random number between 0 and 1 reaches "
               "from one edge of the cell to the other";
    }
    return "";
}

// Samples in wrong places altogether.
inline std::string strayHint(const Samples& samples) {
    if (share(samples, leavesPixel) > 0) {
        return "samples lie beyond the pixel: a cell is only 1 / n wide, its first one begins at "
               "the pixel's corner, and the random number moves a sample from its cell's corner "
               "by less than that";
    }
    if (share(samples, [&](const Sample& s) { return inFirstCell(s, samples.n); }) == 1) {
        return "all samples lie in the first cell: a whole number divided by a whole number is a "
               "whole number, and the fraction is lost";
    }
    return "";
}

/// The first known mistake that explains where the samples lie.
inline std::string placeHint(const Samples& samples) {
    if (wrongCount(samples)) return countHint(samples);
    for (const auto find : {strayHint, randomHint, coverageHint}) {
        const std::string hint = find(samples);
        if (!hint.empty()) return hint;
    }
    return "each sample belongs to one cell of the grid, in which a random number of its own "
           "gives it a place";
}

}  // namespace lab
