#include "accel/shapeLeaves.h"

#include <array>
#include <bit>
#include <map>

#include "accel/filterKernels.h"

namespace sw {
namespace {

constexpr std::size_t sphereRows = 4;
constexpr std::size_t triangleRows = 10;

// The padding at the end lets the last row be read as eight values.
template <typename Shape, std::size_t rowCount, typename Row>
std::vector<float> makeRows(const std::vector<Shape>& shapes, std::span<const std::uint32_t> order,
                            std::span<const int> sizes, Row row) {
    std::vector<float> rows;
    rows.reserve(order.size() * rowCount + simd::lanes);
    std::size_t first = 0;
    for (const int count : sizes) {
        const auto leaf = order.subspan(first, static_cast<std::size_t>(count));
        for (std::size_t r = 0; r < rowCount; ++r)
            for (const std::uint32_t i : leaf) rows.push_back(row(shapes[i], r));
        first += leaf.size();
    }
    rows.resize(rows.size() + simd::lanes);
    return rows;
}

template <std::size_t rowCount>
void prefetchRows(const std::vector<float>& rows, std::size_t first, int count) {
    simd::prefetch(rows.data() + rowCount * first,
                   rowCount * static_cast<std::size_t>(count) * sizeof(float));
}

float sphereRow(const Sphere& sphere, std::size_t r) {
    return r < 3 ? sphere.center[static_cast<int>(r)] : sphere.radius;
}

float triangleRow(const Triangle& triangle, std::size_t r) {
    const auto& v = triangle.vertices;
    if (r < 9) return v[r / 3][static_cast<int>(r % 3)];
    return longestComponent(v[1] - v[0], v[2] - v[0]);
}

template <typename Shape>
MaterialTable materialsOf(const std::vector<Shape>& shapes, std::span<const std::uint32_t> order) {
    using Bits = std::array<std::uint32_t, sizeof(Material) / sizeof(std::uint32_t)>;
    std::map<Bits, std::uint32_t> known;  // by their bits, as NaN is not equal to itself
    MaterialTable table;
    table.numbers.reserve(order.size());
    for (const std::uint32_t i : order) {
        const Material& material = shapes[i].material;
        const auto next = static_cast<std::uint32_t>(table.materials.size());
        const auto [place, isNew] = known.try_emplace(std::bit_cast<Bits>(material), next);
        if (isNew) table.materials.push_back(material);
        table.numbers.push_back(place->second);
    }
    return table;
}

unsigned keep(Mask rejected, int count) {
    return ~bits(rejected) & ((1u << count) - 1);
}

}  // namespace

void SphereLeaves::assign(std::vector<Sphere> spheres, std::span<const std::uint32_t> order,
                          std::span<const int> sizes) {
    rows = makeRows<Sphere, sphereRows>(spheres, order, sizes, sphereRow);
    materials = materialsOf(spheres, order);
}

Sphere SphereLeaves::shape(std::size_t first, int count, int i) const {
    const float* row = rows.data() + sphereRows * first + i;
    return Sphere({row[0], row[count], row[2 * count]}, row[3 * count],
                  materials.of(first + static_cast<std::size_t>(i)));
}

void SphereLeaves::prefetch(std::size_t first, int count) const {
    prefetchRows<sphereRows>(rows, first, count);
}

unsigned SphereLeaves::candidates(const FilterRay& ray, std::size_t first, int count) const {
    const auto stride = static_cast<std::size_t>(count);
    const float* row = rows.data() + sphereRows * first;
    const Float3 f = spread(ray.orig) - loadRows(row, stride);
    return keep(spheresMissed(ray, f, abs(load(row + 3 * stride))), count);
}

void TriangleLeaves::assign(std::vector<Triangle> triangles, std::span<const std::uint32_t> order,
                            std::span<const int> sizes) {
    rows = makeRows<Triangle, triangleRows>(triangles, order, sizes, triangleRow);
    materials = materialsOf(triangles, order);
}

Triangle TriangleLeaves::shape(std::size_t first, int count, int i) const {
    const float* row = rows.data() + triangleRows * first + i;
    Triangle triangle;  // filled in place: reading back what was just written is slow
    triangle.material = materials.of(first + static_cast<std::size_t>(i));
    for (int k = 0; k < 9; ++k) triangle.vertices[k / 3].m[k % 3] = row[k * count];
    return triangle;
}

void TriangleLeaves::prefetch(std::size_t first, int count) const {
    prefetchRows<triangleRows>(rows, first, count);
}

unsigned TriangleLeaves::candidates(const FilterRay& ray, std::size_t first, int count) const {
    const auto stride = static_cast<std::size_t>(count);
    const float* row = rows.data() + triangleRows * first;
    const Float3 v0 = loadRows(row, stride);
    const PlaneHits hits(ray, v0, loadRows(row + 3 * stride, stride) - v0,
                         loadRows(row + 6 * stride, stride) - v0, load(row + 9 * stride));
    const Mask past = hits.v + hits.w > hits.det + hits.detError + 2 * hits.vwError;
    return keep(hits.signKnown & (hits.off | past), count);
}

}  // namespace sw
