#pragma once

// Eight floats at a time: one vector of GCC's and clang's where the target has AVX, else two
// vectors of four (SSE, NEON). Other compilers, and SW_SIMD_PORTABLE, get single floats. Results
// are those of scalar floats.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE__) || defined(_M_X64)
#define SW_SIMD_SSE
#include <immintrin.h>
#endif

#if defined(__GNUC__) && defined(__AVX2__) && !defined(SW_SIMD_PORTABLE)
#define SW_SIMD_PERMUTE  // lanes can be permuted by numbers known only at run time
#endif

// For functions that hand over many vectors, which otherwise go through memory; and for those that
// would take registers from the loop that calls them.
#if defined(__GNUC__)
#define SW_INLINE __attribute__((always_inline)) inline
#define SW_APART __attribute__((noinline))
#elif defined(_MSC_VER)
#define SW_INLINE __forceinline
#define SW_APART __declspec(noinline)
#else
#define SW_INLINE inline
#define SW_APART
#endif

namespace sw::simd {

constexpr int lanes = 8;

#if defined(__GNUC__) && defined(__AVX__) && !defined(SW_SIMD_PORTABLE)

using Float = float __attribute__((vector_size(lanes * sizeof(float))));
using Mask = int __attribute__((vector_size(lanes * sizeof(int))));  // 0 or -1 per lane

inline Float broadcast(float x) {
    return Float{x, x, x, x, x, x, x, x};
}
inline Float min(Float a, Float b) {
    return a < b ? a : b;
}  // b where one is NaN
inline Float max(Float a, Float b) {
    return a > b ? a : b;
}  // b where one is NaN
inline Float abs(Float a) {
    return (Float)((Mask)a & 0x7fffffff);
}

/// x with its sign changed where s is negative (or -0).
inline Float flipSign(Float x, Float s) {
    return (Float)((Mask)x ^ ((Mask)s & static_cast<int>(0x80000000)));
}

/// The last four lanes, then the first four.
inline Float swapHalves(Float a) {
    return __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3);
}

#ifdef SW_SIMD_PERMUTE

/// Eight numbers of three bits each, the lowest first. Only the lowest three bits of a lane count.
inline Mask unpackNumbers(std::uint32_t packed) {
    const __m256i shifts = _mm256_setr_epi32(0, 3, 6, 9, 12, 15, 18, 21);
    return (Mask)_mm256_srlv_epi32(_mm256_set1_epi32(static_cast<int>(packed)), shifts);
}

/// The lane of every number.
inline Mask permute(Mask a, Mask numbers) {
    return (Mask)_mm256_permutevar8x32_epi32((__m256i)a, (__m256i)numbers);
}
inline Float permute(Float a, Mask numbers) {
    return (Float)permute((Mask)a, numbers);
}

#endif

#else

// A part, its bits, and a comparison's result as a mask: 0 or -1 per lane. (GCC compiles vectors of
// eight to much slower code if the target only has vectors of four.)
#if defined(__GNUC__) && !defined(SW_SIMD_PORTABLE)
using Part = float __attribute__((vector_size(16)));
using Bits = std::int32_t __attribute__((vector_size(16)));
SW_INLINE Bits toMask(Bits compared) {
    return compared;
}
#else
using Part = float;
using Bits = std::int32_t;
SW_INLINE Bits toMask(bool compared) {
    return -static_cast<Bits>(compared);
}
#endif
constexpr std::size_t parts = lanes * sizeof(float) / sizeof(Part);

/// Eight lanes. A float stands for eight equal ones, as with the vector types.
struct Float {
    Part part[parts];

    Float() = default;
    SW_INLINE Float(float x) {
        for (Part& p : part) p = x - Part{};
    }
};
struct Mask {
    Bits part[parts];
};

template <typename Result, typename Operation>
SW_INLINE Result each(Operation operation) {
    Result r;
    for (std::size_t i = 0; i < parts; ++i) r.part[i] = operation(i);
    return r;
}

#define SW_SIMD_OPERATOR(Result, Operand, op, convert)                                       \
    SW_INLINE Result operator op(const Operand& a, const Operand& b) {                       \
        return each<Result>([&](std::size_t i) { return convert(a.part[i] op b.part[i]); }); \
    }
SW_SIMD_OPERATOR(Float, Float, +, )
SW_SIMD_OPERATOR(Float, Float, -, )
SW_SIMD_OPERATOR(Float, Float, *, )
SW_SIMD_OPERATOR(Mask, Float, <, toMask)
SW_SIMD_OPERATOR(Mask, Float, >, toMask)
SW_SIMD_OPERATOR(Mask, Float, <=, toMask)
SW_SIMD_OPERATOR(Mask, Mask, &, )
SW_SIMD_OPERATOR(Mask, Mask, |, )
#undef SW_SIMD_OPERATOR

SW_INLINE Float broadcast(float x) {
    return x;
}
SW_INLINE Float min(const Float& a, const Float& b) {
    return each<Float>([&](auto i) { return a.part[i] < b.part[i] ? a.part[i] : b.part[i]; });
}
SW_INLINE Float max(const Float& a, const Float& b) {
    return each<Float>([&](auto i) { return a.part[i] > b.part[i] ? a.part[i] : b.part[i]; });
}
SW_INLINE Float abs(const Float& a) {
    return each<Float>(
        [&](auto i) { return std::bit_cast<Part>(std::bit_cast<Bits>(a.part[i]) & INT32_MAX); });
}
SW_INLINE Float flipSign(const Float& x, const Float& s) {
    return each<Float>([&](auto i) {
        const Bits sign = std::bit_cast<Bits>(s.part[i]) & INT32_MIN;
        return std::bit_cast<Part>(std::bit_cast<Bits>(x.part[i]) ^ sign);
    });
}
SW_INLINE Float swapHalves(const Float& a) {
    return each<Float>([&](auto i) { return a.part[(i + parts / 2) % parts]; });
}

#endif

/// One bit per lane, the first lane lowest.
SW_INLINE unsigned bits(const Mask& m) {
#if defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<__m256>(m)));
#elif defined(SW_SIMD_SSE)
    __m128 half[2];
    std::memcpy(half, &m, sizeof m);
    return static_cast<unsigned>(_mm_movemask_ps(half[0]) | _mm_movemask_ps(half[1]) << 4);
#else
    std::int32_t lane[lanes];
    std::memcpy(lane, &m, sizeof m);
    unsigned result = 0;
    for (int i = 0; i < lanes; ++i) result |= static_cast<unsigned>(lane[i]) & 1u << i;
    return result;
#endif
}

/// Fetches memory that will be read soon.
inline void prefetch([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef __GNUC__
    const char* line = static_cast<const char*>(memory);
    for (std::size_t i = 0; i < bytes; i += 64) __builtin_prefetch(line + i);
#endif
}

/// Eight neighbouring floats, anywhere in memory.
inline Float load(const float* p) {
    Float v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

}  // namespace sw::simd
