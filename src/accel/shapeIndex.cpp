#include "accel/shapeIndex.h"

#include <tuple>

#include "accel/bvhTraversal.h"
#include "accel/shapeSet.h"

namespace sw {
namespace {

// Up to this count a linear scan is as fast as a tree. Measured on scattered spheres and triangles.
constexpr std::size_t linearLimit = 48;

}  // namespace

struct ShapeIndex::Parts {
    std::tuple<ShapeSet<Sphere>, ShapeSet<Triangle>, ShapeSet<Cone>, ShapeSet<Patch>,
               ShapeSet<std::shared_ptr<Primitive>>>
        sets;
    Bvh tree;
    bool isOutside = false;  // any shape, of the tree

    // Calls visit(set) for the set of every type.
    template <typename Visit>
    void eachSet(const Visit& visit) {
        std::apply([&](auto&... set) { (visit(set), ...); }, sets);
    }
    template <typename Visit>
    bool anySet(const Visit& visit) const {
        return std::apply([&](const auto&... set) { return (visit(set) || ...); }, sets);
    }

    void buildTree(int threads);
    void dissolveTree();

    template <Find what>
    bool find(const Ray& ray, Intersection& hit) const;
};

void ShapeIndex::Parts::buildTree(int threads) {
    std::vector<Bounds> boxes;
    std::vector<Bvh::Run> runs;
    eachSet([&](auto& set) {
        const std::size_t before = boxes.size();
        set.addBoxes(boxes);
        runs.push_back({boxes.size() - before, set.leafSize});
    });
    if (boxes.size() <= linearLimit) return;
    tree = Bvh(boxes, runs, threads);
    boxes = {};

    std::vector<std::uint32_t> sizes(tree.order().size());  // 0: no leaf starts here
    tree.eachLeaf([&](std::uint32_t first, std::uint32_t count) { sizes[first] = count; });
    auto run = runs.begin();
    std::size_t first = 0;
    eachSet([&](auto& set) {
        set.moveToLeaves(tree.order().subspan(first, run->count),
                         std::span(sizes).subspan(first, run->count), first);
        first += run++->count;
    });
}

void ShapeIndex::Parts::dissolveTree() {
    if (tree.order().empty()) return;
    eachSet([&](auto& set) { set.takeFromLeaves(tree); });
    tree = Bvh();
}

// Tests the shapes of a leaf that the traversal has reached.
template <typename Sets, typename Search>
struct LeafTest {
    const Sets& sets;
    Search& search;

    bool operator()(std::uint32_t first, std::uint32_t count, float& maxT) const {
        bool found = false, over = false;
        const auto test = [&](const auto& set) {
            if (found || first >= set.endPlace()) return;
            found = true;
            over = set.findInLeaf(search, first, count);
        };
        std::apply([&](const auto&... set) { (test(set), ...); }, sets);
        maxT = search.ray().maxT;
        return over;
    }
};

template <Find what>
bool ShapeIndex::Parts::find(const Ray& ray, Intersection& hit) const {
    Search<what> search(ray, hit, tree.order());
    if (!tree.order().empty()) {
        const LeafTest<decltype(sets), Search<what>> leaf{sets, search};
        tree.traverse(ray, leaf);
        if (what != Find::nearest && search.isFound()) return search.finish();
    }
    if (isOutside) anySet([&](const auto& set) { return set.findOutside(search); });
    return search.finish();
}

ShapeIndex::ShapeIndex() : parts(std::make_unique<Parts>()) {}
ShapeIndex::ShapeIndex(const ShapeIndex& other) : parts(std::make_unique<Parts>(*other.parts)) {}
ShapeIndex::~ShapeIndex() = default;

template <typename Shape>
void ShapeIndex::push(Shape shape) {
    parts->dissolveTree();
    std::get<ShapeSet<Shape>>(parts->sets).push(std::move(shape));
}
template void ShapeIndex::push(Sphere);
template void ShapeIndex::push(Triangle);
template void ShapeIndex::push(Cone);
template void ShapeIndex::push(Patch);
template void ShapeIndex::push(std::shared_ptr<Primitive>);

void ShapeIndex::prepare(int threads) {
    parts->buildTree(threads);
    auto place = static_cast<std::uint32_t>(parts->tree.order().size());
    const auto first = place;
    parts->eachSet([&](auto& set) { place = set.pack(place); });
    parts->isOutside = place > first;
}

std::array<std::size_t, 5> ShapeIndex::sizes() const {
    return std::apply([](const auto&... set) { return std::array{set.size()...}; }, parts->sets);
}

bool ShapeIndex::hasTree() const {
    return !parts->tree.order().empty();
}

bool ShapeIndex::find(const Ray& ray, Intersection& hit, bool any) const {
    return any ? parts->find<Find::any>(ray, hit) : parts->find<Find::nearest>(ray, hit);
}
bool ShapeIndex::isHit(const Ray& ray) const {
    Intersection unused;
    return parts->find<Find::whether>(ray, unused);
}

}  // namespace sw
