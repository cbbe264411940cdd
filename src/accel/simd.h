#pragma once

// Eight floats at a time. GCC and clang compile the vector type to what the target has (AVX, SSE,
// NEON); other compilers, and SW_SIMD_PORTABLE, get loops. Results are those of scalar floats.

#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __AVX__
#include <immintrin.h>
#endif

#if defined(__GNUC__) && defined(__AVX2__) && !defined(SW_SIMD_PORTABLE)
#define SW_SIMD_PERMUTE  // lanes can be permuted by numbers known only at run time
#endif

// For functions that hand over many vectors, which otherwise go through memory; and for those that
// would take registers from the loop that calls them.
#ifdef __GNUC__
#define SW_INLINE __attribute__((always_inline)) inline
#define SW_APART __attribute__((noinline))
#else
#define SW_INLINE inline
#define SW_APART
#endif

namespace sw::simd {

constexpr int lanes = 8;

#if defined(__GNUC__) && !defined(SW_SIMD_PORTABLE)

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

/// One bit per lane, the first lane lowest.
inline unsigned bits(Mask m) {
#if defined(__AVX__)
    return static_cast<unsigned>(_mm256_movemask_ps((__m256)m));
#else
    unsigned result = 0;
    for (int i = 0; i < lanes; ++i) result |= static_cast<unsigned>(m[i] & 1) << i;
    return result;
#endif
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

struct Float {
    float lane[lanes];
};
struct Mask {
    bool lane[lanes];
};

template <typename Result, typename Operation>
Result each(Operation operation) {
    Result r;
    for (int i = 0; i < lanes; ++i) r.lane[i] = operation(i);
    return r;
}

inline Float broadcast(float x) {
    return each<Float>([&](int) { return x; });
}
#define SW_SIMD_OPERATOR(Result, op)                                        \
    inline Result operator op(const Float& a, const Float& b) {             \
        return each<Result>([&](int i) { return a.lane[i] op b.lane[i]; }); \
    }
SW_SIMD_OPERATOR(Float, +)
SW_SIMD_OPERATOR(Float, -)
SW_SIMD_OPERATOR(Float, *)
SW_SIMD_OPERATOR(Mask, <)
SW_SIMD_OPERATOR(Mask, >)
SW_SIMD_OPERATOR(Mask, <=)
#undef SW_SIMD_OPERATOR
inline Mask operator|(const Mask& a, const Mask& b) {
    return each<Mask>([&](int i) { return a.lane[i] || b.lane[i]; });
}
inline Mask operator&(const Mask& a, const Mask& b) {
    return each<Mask>([&](int i) { return a.lane[i] && b.lane[i]; });
}
inline Float min(const Float& a, const Float& b) {
    return each<Float>([&](int i) { return a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]; });
}
inline Float max(const Float& a, const Float& b) {
    return each<Float>([&](int i) { return a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i]; });
}
inline Float abs(const Float& a) {
    return each<Float>([&](int i) { return a.lane[i] < 0 ? -a.lane[i] : a.lane[i]; });
}
inline Float flipSign(const Float& x, const Float& s) {
    return each<Float>([&](int i) { return s.lane[i] < 0 ? -x.lane[i] : x.lane[i]; });
}
inline Float swapHalves(const Float& a) {
    return each<Float>([&](int i) { return a.lane[(i + lanes / 2) % lanes]; });
}
inline unsigned bits(const Mask& m) {
    unsigned result = 0;
    for (int i = 0; i < lanes; ++i) result |= static_cast<unsigned>(m.lane[i]) << i;
    return result;
}

#endif

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
