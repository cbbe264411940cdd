#include <stdexcept>

#include "accel/bvhBuild.h"

namespace sw::bvh {

LeafRule::LeafRule(std::span<const BvhRun> runs) {
    std::uint32_t end = 0;
    for (const BvhRun& run : runs) {
        if (run.leafSize < 1 || run.leafSize > 8)
            throw std::invalid_argument("Bvh: leaf size not in 1..8");
        if (run.count == 0) continue;
        ends.push_back(end += static_cast<std::uint32_t>(run.count));
        sizes.push_back(static_cast<std::uint32_t>(run.leafSize));
        most = std::max(most, sizes.back());
    }
}

bool LeafRule::allows(std::span<const Item> items) const {
    if (items.size() > most) return false;
    const std::size_t run = ends.size() == 1 ? 0 : runOf(items[0].number());
    if (items.size() > sizes[run]) return false;
    return ends.size() == 1 || std::all_of(items.begin(), items.end(), [&](const Item& item) {
               return runOf(item.number()) == run;
           });
}

std::uint32_t LeafRule::sortByRun(std::span<Item> items) const {
    const auto before = [](const Item& a, const Item& b) { return a.number() < b.number(); };
    std::sort(items.begin(), items.end(), before);
    const std::size_t run = runOf(items[0].number());
    return static_cast<std::uint32_t>(std::count_if(
        items.begin(), items.end(), [&](const Item& item) { return runOf(item.number()) == run; }));
}

std::vector<std::uint32_t> LeafRule::starts() const {
    std::vector<std::uint32_t> result{0};
    result.insert(result.end(), ends.begin(), ends.end());
    return result;
}

}  // namespace sw::bvh
