#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

#include "accel/bvhBuild.h"

namespace sw::bvh {
namespace {

constexpr int maxBins = 16;

// Finds the bin of a centroid, on all three axes at once.
class Binning {
public:
    Binning(const Float& centroids, int bins)
        : last(simd::broadcast(static_cast<float>(bins - 1))) {
        const Float swapped = simd::swapHalves(centroids);
        Item extent, factor{};
        store(centroids + swapped, extent);
        for (int axis = 0; axis < 3; ++axis) {
            const float perUnit = static_cast<float>(bins) / extent.lane[axis];
            separable[axis] = extent.lane[axis] > 0 && perUnit > 0 && perUnit <= FLT_MAX;
            if (separable[axis]) factor.lane[axis + 4] = perUnit;
        }
        minusLowest = swapped;
        scale = simd::load(factor.lane);
    }

    // Fills in lanes 4 to 6: the bins along x, y and z.
    void operator()(const Float& centroidBox, int (&bin)[simd::lanes]) const {
        Item k;
        store(simd::min((centroidBox + minusLowest) * scale, last), k);
        for (int i = 4; i < 7; ++i) bin[i] = static_cast<int>(k.lane[i]);
    }

    bool separable[3];

private:
    static void store(const Float& from, Item& to) { std::memcpy(to.lane, &from, sizeof from); }

    Float minusLowest, scale, last;
};

struct Bins {
    Float box[3][maxBins];
    std::uint32_t count[3][maxBins];
};

void fill(Bins& bins, int n, std::span<const Item> items, const Binning& binning) {
    const Float empty = emptyBox();
    for (int axis = 0; axis < 3; ++axis) {
        std::fill_n(bins.box[axis], n, empty);
        std::fill_n(bins.count[axis], n, 0u);
    }
    for (const Item& item : items) {
        const Float box = simd::load(item.lane);
        int bin[simd::lanes];
        binning(centroid(box), bin);
        for (int axis = 0; axis < 3; ++axis) {
            Float& sum = bins.box[axis][bin[axis + 4]];
            sum = simd::max(sum, box);
            ++bins.count[axis][bin[axis + 4]];
        }
    }
}

// Small ranges get fewer bins: sweeping over 16 would cost more than the items themselves.
int binsFor(std::uint32_t count) {
    return count < 64 ? 8 : maxBins;
}

}  // namespace

Float emptyBox() {
    return simd::broadcast(-Bounds::infinity);
}

float halfArea(const Float& box, float scale) {
    const Float scaled = box * simd::broadcast(scale);
    const Float extent = scaled + simd::swapHalves(scaled);
    float e[simd::lanes];
    std::memcpy(e, &extent, sizeof e);
    return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
}

Range SahSplitter::around(std::uint32_t first, std::uint32_t count) const {
    Range range{first, count, emptyBox(), emptyBox()};
    for (const Item& item : items.subspan(first, count)) {
        const Float box = simd::load(item.lane);
        range.box = simd::max(range.box, box);
        range.centroids = simd::max(range.centroids, centroid(box));
    }
    return range;
}

Range SahSplitter::whole() {
    const Range range = around(0, static_cast<std::uint32_t>(items.size()));
    float b[simd::lanes];
    std::memcpy(b, &range.box, sizeof b);
    float largest = 0;
    for (int i = 0; i < 3; ++i) largest = std::max(largest, b[i] * 0.5f + b[i + 4] * 0.5f);
    if (largest > 0) scale = std::ldexp(1.0f, std::clamp(-std::ilogb(largest), -126, 126));
    return range;
}

// Finds the cheapest split between the bins of an axis, if it costs less than `best`.
void SahSplitter::sweep(const Float* boxes, const std::uint32_t* counts, int axis,
                        Split& best) const {
    Float right[maxBins];
    float rightCost[maxBins];
    Float box = emptyBox();
    std::uint32_t count = 0;
    for (int i = best.bins - 1; i > 0; --i) {
        right[i] = box = simd::max(box, boxes[i]);
        count += counts[i];
        rightCost[i] = count == 0 ? HUGE_VALF : halfArea(box, scale) * cost(count);
    }
    box = emptyBox();
    count = 0;
    for (int i = 0; i + 1 < best.bins; ++i) {
        box = simd::max(box, boxes[i]);
        count += counts[i];
        if (count == 0) continue;
        const float sum = halfArea(box, scale) * cost(count) + rightCost[i + 1];
        if (sum < best.cost) best = {axis, i, best.bins, sum, box, right[i + 1]};
    }
}

SahSplitter::Split SahSplitter::findSplit(const Range& range) const {
    Split best;
    best.bins = binsFor(range.count);
    const Binning binning(range.centroids, best.bins);
    Bins bins;
    fill(bins, best.bins, in(range), binning);
    for (int axis = 0; axis < 3; ++axis)
        if (binning.separable[axis]) sweep(bins.box[axis], bins.count[axis], axis, best);
    return best;
}

void SahSplitter::partition(const Split& split, const Range& range, Range& left,
                            Range& right) const {
    if (split.axis < 0) return splitWithoutAxis(range, left, right);
    const Binning binning(range.centroids, split.bins);
    const Float keep = simd::broadcast(0), drop = emptyBox();
    const Float toLeft[2] = {drop, keep}, toRight[2] = {keep, drop};
    Float leftCentroids = drop, rightCentroids = drop;
    Item* middle = &items[range.first];
    for (Item& item : in(range)) {
        const Float box = simd::load(item.lane);
        const Float c = centroid(box);
        int bin[simd::lanes];
        binning(c, bin);
        const bool isLeft = bin[split.axis + 4] <= split.bin;
        leftCentroids = simd::max(leftCentroids, c + toLeft[isLeft]);
        rightCentroids = simd::max(rightCentroids, c + toRight[isLeft]);
        item = *middle;  // Lomuto's partition, without a branch
        std::memcpy(middle, &box, sizeof box);
        middle += isLeft;
    }
    const auto leftCount = static_cast<std::uint32_t>(middle - &items[range.first]);
    left = {range.first, leftCount, split.left, leftCentroids};
    right = {range.first + leftCount, range.count - leftCount, split.right, rightCentroids};
}

void SahSplitter::splitWithoutAxis(const Range& range, Range& left, Range& right) const {
    std::uint32_t count = range.count / 2;
    if (range.count <= leafSize && !isLeaf(range)) {
        const Item first = items[range.first];
        const auto end = std::partition(in(range).begin(), in(range).end(),
                                        [&](auto& item) { return item.hasKindOf(first); });
        count = static_cast<std::uint32_t>(end - in(range).begin());
    }
    left = around(range.first, count);
    right = around(range.first + count, range.count - count);
}

bool SahSplitter::isLeaf(const Range& range) const {
    return range.count <= leafSize &&
           std::all_of(in(range).begin(), in(range).end(),
                       [&](const Item& item) { return item.hasKindOf(items[range.first]); });
}

}  // namespace sw::bvh
