#include "accel/shapeIndex.h"

#include <numeric>
#include <tuple>
#include <utility>

#include "accel/bvhTraversal.h"
#include "accel/shapeBlocks.h"
#include "accel/trianglePacket.h"

namespace sw {
namespace {

// Up to this count a linear scan is as fast as a tree. Measured on scattered spheres and triangles.
constexpr std::size_t linearLimit = 48;

// Types of shapes, in the order in which they count.
enum Type : std::uint8_t { spheres, triangles, cones, patches, foreign, types };  // types: how many

Bounds boundsOf(const Primitive& shape) {
    return shape.bounds();
}
Bounds boundsOf(const Foreign& shape) {
    return shape->bounds();
}

}  // namespace

struct ShapeIndex::Parts {
    // In order of their numbers. Once all are packed, only those that are in no block: foreign
    // primitives, and the triangles of packets.
    std::tuple<std::vector<Sphere>, std::vector<Triangle>, std::vector<Cone>, std::vector<Patch>,
               std::vector<Foreign>>
        shapes;
    std::array<std::uint32_t, types + 1> first{};  // number of each type, and how many there are

    bool isPacked = false;
    ShapeBlocks blocks;
    Bvh tree;                            // its leaves are blocks
    std::vector<std::uint32_t> scanned;  // the other blocks
    std::vector<TrianglePacket> packets;

    // Calls visit(vector, type) for the shapes of every type.
    template <typename Visit>
    void eachType(const Visit& visit) {
        std::uint8_t type = 0;
        std::apply([&](auto&... all) { (visit(all, type++), ...); }, shapes);
    }
    std::uint8_t typeOf(std::uint32_t number) const {
        return static_cast<std::uint8_t>(std::upper_bound(first.begin(), first.end(), number) -
                                         first.begin() - 1);
    }

    bool hasTree() const { return !tree.tree().empty(); }
    void pack(int threads);
    void unpack();

    template <Find what>
    bool find(const Ray& ray, Intersection& hit) const;

private:
    void plantTree(const std::vector<Bounds>& boxes, std::span<const std::uint32_t> numbers,
                   int threads);
    void addScanned(std::span<const std::uint32_t> numbers);
    std::uint32_t addBlock(std::span<const std::uint32_t> numbers);

    template <Find what>
    bool test(Search<what>& search, std::uint32_t place) const;
    template <Find what>
    void scan(Search<what>& search) const;
};

void ShapeIndex::Parts::pack(int threads) {
    if (std::exchange(isPacked, true)) return;
    std::vector<Bounds> boxes;
    std::vector<std::uint32_t> bounded, others;
    eachType([&](const auto& all, std::size_t type) {
        first[type + 1] = first[type] + static_cast<std::uint32_t>(all.size());
    });
    boxes.reserve(first[types]);
    bounded.reserve(first[types]);
    std::uint32_t number = 0;
    eachType([&](const auto& all, std::size_t) {
        for (const auto& shape : all) {
            const Bounds box = boundsOf(shape);
            if (box.isFinite()) boxes.push_back(box);
            (box.isFinite() ? bounded : others).push_back(number++);
        }
    });
    if (boxes.size() > linearLimit) {
        plantTree(boxes, bounded, threads);
    } else {
        packets = packetsOf(std::get<triangles>(shapes));
        others.resize(number);
        std::iota(others.begin(), others.end(), 0u);
    }
    addScanned(others);
    blocks.finish();
    eachType([&](auto& all, std::uint8_t type) {
        if (type != foreign && (type != triangles || packets.empty())) all = {};
    });
}

void ShapeIndex::Parts::plantTree(const std::vector<Bounds>& boxes,
                                  std::span<const std::uint32_t> numbers, int threads) {
    std::vector<std::uint32_t> kinds;
    kinds.reserve(numbers.size());
    for (const std::uint32_t n : numbers)  // every foreign primitive is of a kind of its own
        kinds.push_back(n < first[foreign] ? typeOf(n) : foreign + n);
    tree = Bvh(boxes, 8, threads, kinds);
    std::size_t floats = 0;
    tree.eachLeaf([&](std::span<const std::uint32_t> leaf) {
        eachType([&]<typename Shape>(const std::vector<Shape>&, std::uint8_t type) {
            if (type == typeOf(numbers[leaf[0]])) floats += ShapeBlocks::size<Shape>(leaf.size());
        });
    });
    blocks.reserve(floats);
    tree.numberLeaves([&](std::span<const std::uint32_t> leaf) {
        std::array<std::uint32_t, 8> own;
        std::transform(leaf.begin(), leaf.end(), own.begin(), [&](auto i) { return numbers[i]; });
        return addBlock({own.data(), leaf.size()});
    });
}

// All but the triangles in packets.
void ShapeIndex::Parts::addScanned(std::span<const std::uint32_t> numbers) {
    for (std::size_t i = 0, count = 1; i < numbers.size(); i += count) {
        const std::uint8_t type = typeOf(numbers[i]);
        const std::size_t most = type == foreign ? 1 : std::min<std::size_t>(numbers.size() - i, 8);
        for (count = 1; count < most && typeOf(numbers[i + count]) == type;) ++count;
        if (type != triangles || packets.empty())
            scanned.push_back(addBlock(numbers.subspan(i, count)));
    }
}

// Returns the place of the block.
std::uint32_t ShapeIndex::Parts::addBlock(std::span<const std::uint32_t> numbers) {
    std::uint32_t place = 0;
    eachType([&]<typename Shape>(const std::vector<Shape>& all, std::uint8_t type) {
        const auto shape = [&](std::uint32_t number) -> auto& {
            return all[number - first[type]];
        };
        if (typeOf(numbers[0]) == type) place = blocks.add<Shape>(type, numbers, shape);
    });
    return place;
}

// The reverse of pack(): the shapes are as they were pushed.
void ShapeIndex::Parts::unpack() {
    if (!std::exchange(isPacked, false)) return;
    eachType([&]<typename Shape>(std::vector<Shape>& all, std::uint8_t type) {
        if constexpr (!std::is_same_v<Shape, Foreign>) {
            all.resize(first[type + 1u] - first[type]);
            blocks.eachShape<Shape>(type, [&](const Shape& shape, std::uint32_t number) {
                all[number - first[type]] = shape;
            });
        }
    });
    blocks = {};
    tree = {};
    scanned.clear();
    packets.clear();
}

// Tests the shapes of a block.
template <Find what>
SW_APART bool ShapeIndex::Parts::test(Search<what>& search, std::uint32_t place) const {
    const std::uint8_t type = blocks.typeOf(place);
    if (type == triangles) return blocks.test<Triangle>(search, place);
    if (type == spheres) return blocks.test<Sphere>(search, place);
    if (type == cones) return blocks.test<Cone>(search, place);
    if (type == patches) return blocks.test<Patch>(search, place);
    const std::uint32_t number = blocks.foreignNumber(place);
    return search.test(std::get<foreign>(shapes)[number - first[foreign]], number);
}

// Tests all shapes that stand in no tree.
template <Find what>
SW_APART void ShapeIndex::Parts::scan(Search<what>& search) const {
    for (const std::uint32_t place : scanned) {
        const bool ofSpheres = blocks.typeOf(place) == spheres;  // as in the lab's scene: no call
        if (ofSpheres ? blocks.test<Sphere>(search, place) : test(search, place)) return;
    }
    for (const TrianglePacket& packet : packets) {
        const auto test = [&](std::uint32_t bit) {
            const std::uint32_t i = packet.number(bit);
            return search.test(std::get<triangles>(shapes)[i], first[triangles] + i);
        };
        if (testEach(search, packet.filter(search.filterRay), packet.bits(), test)) return;
    }
}

template <Find what>
bool ShapeIndex::Parts::find(const Ray& ray, Intersection& hit) const {
    Search<what> search(ray, hit);
    if (!hasTree()) {
        scan(search);
        return search.finish();
    }
    tree.traverse(ray, [&](std::uint32_t place, std::uint32_t, float& limit) {
        const bool isOver = test(search, place);
        limit = search.limit;
        return isOver;
    });
    if (!scanned.empty() && !search.isOver()) scan(search);
    return search.finish();
}

ShapeIndex::ShapeIndex() : parts(std::make_unique<Parts>()) {}
ShapeIndex::ShapeIndex(const ShapeIndex& other) : parts(std::make_unique<Parts>(*other.parts)) {}
ShapeIndex::~ShapeIndex() = default;

template <typename Shape>
void ShapeIndex::push(Shape shape) {
    parts->unpack();
    std::get<std::vector<Shape>>(parts->shapes).push_back(std::move(shape));
}
template void ShapeIndex::push(Sphere);
template void ShapeIndex::push(Triangle);
template void ShapeIndex::push(Cone);
template void ShapeIndex::push(Patch);
template void ShapeIndex::push(Foreign);

void ShapeIndex::prepare(int threads) {
    parts->pack(threads);
}

std::array<std::size_t, 5> ShapeIndex::sizes() const {
    const auto& n = parts->first;
    return {n[1] - n[0], n[2] - n[1], n[3] - n[2], n[4] - n[3], n[5] - n[4]};
}

bool ShapeIndex::hasTree() const {
    return parts->hasTree();
}

bool ShapeIndex::find(const Ray& ray, Intersection& hit, bool any) const {
    return any ? parts->find<Find::any>(ray, hit) : parts->find<Find::nearest>(ray, hit);
}

bool ShapeIndex::isHit(const Ray& ray) const {
    Intersection unused;
    return parts->find<Find::whether>(ray, unused);
}

}  // namespace sw
