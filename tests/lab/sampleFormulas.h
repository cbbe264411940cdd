#pragma once

#include "lab/samples.h"

/// The formulas of known mistakes for where a sample lies along one axis.
namespace lab {

/// A cell along one axis, in the pixel that begins at `corner`.
struct Cell {
    float corner;  ///< x or y
    float i;       ///< the cell's index
    float u;       ///< a random number
    float n;
};

struct Formula {
    float (*place)(const Cell&);  ///< in the picture, as the camera is asked
    const char* hint;
};

/// Few enough to compare all their samples with all formulas.
inline const std::vector<Samples>& fewSamples() {
    static const std::vector<Samples> few{manySamples(2, 40), manySamples(3, 40),
                                          manySamples(5, 40)};
    return few;
}

template <typename Is>
bool allFew(Is is) {
    return std::all_of(fewSamples().begin(), fewSamples().end(), is);
}

/// Whether the formula gives this place for the cell with that index and one of the pixel's random
/// numbers.
inline bool isPlace(const Formula& formula, float place, Cell cell,
                    const std::vector<float>& numbers) {
    return std::any_of(numbers.begin(), numbers.end(), [&](float u) {
        cell.u = u;
        return std::fabs(formula.place(cell) - place) < 2e-6f * (2 + std::fabs(place));
    });
}

/// Whether the formula explains where the k-th pixel's samples lie along that axis: each by some
/// cell, and each cell by some sample.
inline bool explains(const Formula& formula, const Samples& samples, std::size_t k,
                     float Sample::*axis) {
    const Pixel& pixel = samples.pixels[k];
    const float corner = static_cast<float>(axis == &Sample::x ? pixel.x : pixel.y);
    std::vector<bool> explained(pixel.samples.size(), false);
    for (int i = 0; i < samples.n; ++i) {
        const Cell cell{corner, static_cast<float>(i), 0, static_cast<float>(samples.n)};
        bool used = false;
        for (std::size_t s = 0; s < explained.size(); ++s) {
            if (!isPlace(formula, corner + pixel.samples[s].*axis, cell, samples.numbers[k]))
                continue;
            used = explained[s] = true;
        }
        if (!used) return false;
    }
    return std::find(explained.begin(), explained.end(), false) == explained.end();
}

/// Whether the formula explains where all samples lie along that axis.
inline bool fits(const Formula& formula, float Sample::*axis) {
    return allFew([&](const Samples& samples) {
        for (std::size_t k = 0; k < samples.pixels.size(); ++k)
            if (!explains(formula, samples, k, axis)) return false;
        return true;
    });
}

inline bool isRight(float Sample::*axis) {
    return fits({[](const Cell& c) { return c.corner + (c.i + c.u) / c.n; }, ""}, axis);
}

inline const std::vector<Formula>& withoutNumbers() {
    static const std::vector<Formula> formulas{
        {[](const Cell& c) { return c.corner; },
         "all samples lie on the pixel's first edge: i / n and 1 / n in whole numbers are 0, and "
         "so "
         "is what rounding down leaves of a place in the cell"},
        {[](const Cell& c) { return c.corner + c.i; },
         "samples lie beyond the pixel, as i counts cells and not pixels: a cell is only 1 / n "
         "wide"},
        {[](const Cell& c) { return c.corner + 1; },
         "all samples lie on the pixel's last edge, as if their places were rounded up"},
        {[](const Cell& c) { return c.corner + 0.5f; },
         "all samples lie in the middle of the pixel: each cell has a place of its own"},
        {[](const Cell& c) { return c.corner + (c.i + 0.5f) / c.n; },
         "all samples lie in the centres of their cells: a random number moves each to some other "
         "place in its cell, and turns steps into noise"},
        {[](const Cell& c) { return c.corner + c.i / c.n; },
         "all samples lie in the corners of their cells: a random number moves each to some place "
         "inside"}};
    return formulas;
}

inline const std::vector<Formula>& withWrongScale() {
    static const std::vector<Formula> formulas{
        {[](const Cell& c) { return c.corner + c.u / c.n; },
         "all samples lie in the first row or column of cells: either i is missing, or i / n is 0 "
         "as both are whole numbers"},
        {[](const Cell& c) { return c.corner + c.u; },
         "the samples lie anywhere in the pixel: each has a cell of its own, and stays in it"},
        {[](const Cell& c) { return c.corner + c.i / c.n + c.u; },
         "the random number moves samples by up to a whole pixel, but a cell is only 1 / n wide"},
        {[](const Cell& c) { return c.corner + c.i + c.u / c.n; },
         "samples lie beyond the pixel, as i counts cells and not pixels: a cell is only 1 / n "
         "wide"},
        {[](const Cell& c) { return c.corner + c.i + c.u; },
         "samples lie beyond the pixel: its cells are as wide as it is, but should be 1 / n wide"},
        {[](const Cell& c) { return c.corner + (c.i + c.u) / (c.n + 1); },
         "the samples cover only part of the pixel: its cells are 1 / (n + 1) wide, but n of them "
         "fill it from edge to edge"},
        {[](const Cell& c) { return c.corner + (c.i + c.u) / (c.n - 1); },
         "samples lie beyond the pixel: its cells are 1 / (n - 1) wide, but n of them fill it from "
         "edge to edge"},
        {[](const Cell& c) { return c.corner + (c.i + c.u) / (c.n * c.n); },
         "the samples cover only part of the pixel: a row of n cells is not n * n cells wide"},
        {[](const Cell& c) { return c.corner + c.i * c.u / c.n; },
         "the random number is multiplied by the cell's index, where it has to be added: it moves "
         "a sample away from the cell's edge"}};
    return formulas;
}

inline const std::vector<Formula>& withWrongOrigin() {
    static const char* const scaledCorner =
        "the corner of the pixel itself is divided by n or multiplied by a random number: only the "
        "way from there to the sample is a fraction";
    static const char* const moved =
        "samples lie beyond the pixel: a random number from 0 to 1 moves a sample from its cell's "
        "first edge up to the last one, and nothing more is to be added or taken away";
    static const std::vector<Formula> formulas{
        {[](const Cell& c) { return (c.corner + c.i + c.u) / c.n; }, scaledCorner},
        {[](const Cell& c) { return (c.corner + c.u) / c.n; }, scaledCorner},
        {[](const Cell& c) { return c.corner * c.u / c.n; }, scaledCorner},
        {[](const Cell& c) { return c.corner * c.u; }, scaledCorner},
        {[](const Cell& c) { return c.corner * (c.i + c.u) / c.n; }, scaledCorner},
        {[](const Cell& c) { return (c.corner + c.i) * c.u / c.n; }, scaledCorner},
        {[](const Cell& c) { return c.corner * c.u / c.n + c.i; }, scaledCorner},
        {[](const Cell& c) { return c.corner * c.u / c.n + c.i / c.n; }, scaledCorner},
        {[](const Cell& c) { return c.corner + (c.i + c.u - 0.5f) / c.n; }, moved},
        {[](const Cell& c) { return c.corner + (c.i + c.u + 0.5f) / c.n; }, moved},
        {[](const Cell& c) { return c.corner + (c.i + c.u) / c.n + 0.5f; },
         "samples lie beyond the pixel: its first cell begins at its corner, not in its middle"},
        {[](const Cell& c) { return c.corner + (c.i + c.u) / c.n - 0.5f; },
         "samples lie beyond the pixel: (x, y) is its corner, not its middle"},
        {[](const Cell& c) { return c.corner + (c.i + 1 + c.u) / c.n; },
         "samples lie beyond the pixel: its first cell has the index 0, not 1"}};
    return formulas;
}

/// The first formula that explains all samples along an axis; nullptr where the right one does, and
/// where none does.
inline const Formula* formulaOf(float Sample::*axis) {
    if (isRight(axis)) return nullptr;
    for (const auto formulas : {withoutNumbers, withWrongScale, withWrongOrigin})
        for (const Formula& formula : formulas())
            if (fits(formula, axis)) return &formula;
    return nullptr;
}

/// Its hint; empty if there is none.
inline std::string formulaHint() {
    const Formula *x = formulaOf(&Sample::x), *y = formulaOf(&Sample::y);
    if (x == nullptr && y == nullptr) return "";
    if (x == nullptr) return std::string("in y, ") + y->hint;
    return x == y ? x->hint : std::string("in x, ") + x->hint;
}

/// Whether nothing random is in either axis: then no other formula fits.
inline bool isWithoutNumbers() {
    const auto known = [](float Sample::*axis) {
        return std::any_of(withoutNumbers().begin(), withoutNumbers().end(),
                           [&](const Formula& formula) { return fits(formula, axis); });
    };
    return known(&Sample::x) && known(&Sample::y);
}

}  // namespace lab
