#include "swSamplePattern.h"

#include <numeric>
#include <utility>

namespace sw {
namespace {

// The cell (i, j) of an n x n grid.
struct Cell {
    int i, j, n;
    SamplePoint at(float x, float y) const {
        const float cells = static_cast<float>(n);
        return {(static_cast<float>(i) + x) / cells, (static_cast<float>(j) + y) / cells};
    }
};

template <typename Place>
std::vector<SamplePoint> forEachCell(int n, const Place& place) {
    std::vector<SamplePoint> points;
    points.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) points.push_back(place(Cell{i, j, n}));
    return points;
}

SamplePoint jittered(const Cell& cell) {
    const float x = uniform();  // first, whatever the order of a call's arguments
    return cell.at(x, uniform());
}

// 0 .. n-1 in random order (Fisher and Yates; Knuth, The Art of Computer Programming, 3.4.2 P).
std::vector<int> shuffled(int n) {
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t left = order.size(); left > 1; --left)
        std::swap(order[left - 1],
                  order[static_cast<std::size_t>(uniform() * static_cast<float>(left))]);
    return order;
}

// Correlated multi-jittered sampling (Kensler, Correlated Multi-Jittered Sampling, Pixar Technical
// Memo 13-01, 2013). Each cell is divided into n narrow columns and n narrow rows. All cells of a
// row use the same narrow column, and each row another one; so do columns with narrow rows.
std::vector<SamplePoint> multiJittered(int n) {
    const std::vector<int> column = shuffled(n), row = shuffled(n);
    return forEachCell(n, [&](const Cell& cell) {
        const Cell narrow{column[static_cast<std::size_t>(cell.j)],
                          row[static_cast<std::size_t>(cell.i)], n};
        const SamplePoint p = jittered(narrow);
        return cell.at(p.x, p.y);
    });
}

}  // namespace

std::vector<SamplePoint> samplePoints(SamplePattern pattern, int n) {
    if (pattern == SamplePattern::random)
        return forEachCell(n, [](const Cell&) { return jittered(Cell{0, 0, 1}); });
    if (pattern == SamplePattern::grid || n == 1)
        return forEachCell(n, [](const Cell& cell) { return cell.at(0.5f, 0.5f); });
    return pattern == SamplePattern::multiJitter ? multiJittered(n) : forEachCell(n, jittered);
}

Color samplePixelWith(SamplePattern pattern, float x, float y, int n,
                      const std::function<Color(float x, float y)>& radiance) {
    SampleMean mean;
    for (const SamplePoint& p : samplePoints(pattern, n)) mean += radiance(x + p.x, y + p.y);
    return mean;
}

}  // namespace sw
