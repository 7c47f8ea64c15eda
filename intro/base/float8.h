// Eight floats (or eight 32-bit ints, or eight lane masks) in one AVX register, on GCC's vector extensions.
//
// Masks are Int8, as comparisons return them: a true lane has all bits set, a false lane has none. With the
// scalar overloads below, one template computes a single float or eight of them, with bit-identical results.
// Contraction is off in the whole build, so only fmadd() fuses a multiply and an add.
#pragma once

#include "base/avx.h"

#include <stdint.h>

// For functions of one or two instructions. Under -Os the compiler would not inline them. A call passes its
// arguments in memory, which takes more bytes and is many times slower.
#define ODRAZ_INLINE [[gnu::always_inline]] inline

namespace odraz {

using Float8 = float __attribute__((vector_size(32)));
using Int8 = int32_t __attribute__((vector_size(32)));
using Uint8 = uint32_t __attribute__((vector_size(32)));

inline constexpr Int8 kLanes = {0, 1, 2, 3, 4, 5, 6, 7};
inline constexpr float kInfinity = 1e30f; // finite: the engine is compiled without infinities

ODRAZ_INLINE Float8 broadcast(float x) { return x - Float8{}; } // keeps -0 and NaN
ODRAZ_INLINE Int8 broadcast(int32_t x) { return x - Int8{}; }

// --- Functions of one float or of eight ---

#ifdef __wasm__ // fuses only vectors of four
ODRAZ_INLINE float fmadd(float a, float b, float c) {
    return wasm::madd(_mm_set1_ps(a), _mm_set1_ps(b), _mm_set1_ps(c))[0];
}
#else
ODRAZ_INLINE float fmadd(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
#endif
ODRAZ_INLINE Float8 fmadd(Float8 a, Float8 b, Float8 c) { return _mm256_fmadd_ps(a, b, c); }

ODRAZ_INLINE float sqrt(float x) { return __builtin_sqrtf(x); }
ODRAZ_INLINE Float8 sqrt(Float8 x) { return _mm256_sqrt_ps(x); }

ODRAZ_INLINE float abs(float x) { return __builtin_fabsf(x); }
ODRAZ_INLINE Float8 abs(Float8 x) { return (Float8)((Int8)x & 0x7fffffff); }

ODRAZ_INLINE float floor(float x) { return __builtin_floorf(x); }
ODRAZ_INLINE Float8 floor(Float8 x) { return _mm256_floor_ps(x); }

// Rounds to the nearest integer, halves to even.
ODRAZ_INLINE float round(float x) {
    return _mm_cvtss_f32(
        _mm_round_ss(_mm_set_ss(x), _mm_set_ss(x), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
}
ODRAZ_INLINE Float8 round(Float8 x) {
    return _mm256_round_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

// If an operand is NaN, the result is the second one, as in minps and maxps.
ODRAZ_INLINE float min(float a, float b) { return a < b ? a : b; }
ODRAZ_INLINE Float8 min(Float8 a, Float8 b) { return _mm256_min_ps(a, b); }
ODRAZ_INLINE float max(float a, float b) { return a > b ? a : b; }
ODRAZ_INLINE Float8 max(Float8 a, Float8 b) { return _mm256_max_ps(a, b); }

ODRAZ_INLINE int min(int a, int b) { return a < b ? a : b; }
ODRAZ_INLINE int max(int a, int b) { return a > b ? a : b; }

ODRAZ_INLINE float select(bool m, float a, float b) { return m ? a : b; }
ODRAZ_INLINE Float8 select(Int8 m, Float8 a, Float8 b) { return _mm256_blendv_ps(b, a, (Float8)m); }
ODRAZ_INLINE Int8 select(Int8 m, Int8 a, Int8 b) {
    return (Int8)_mm256_blendv_ps((Float8)b, (Float8)a, (Float8)m);
}

ODRAZ_INLINE constexpr int32_t bits(float x) { return __builtin_bit_cast(int32_t, x); }
ODRAZ_INLINE Int8 bits(Float8 x) { return (Int8)x; }
ODRAZ_INLINE constexpr float fromBits(int32_t x) { return __builtin_bit_cast(float, x); }
ODRAZ_INLINE Float8 fromBits(Int8 x) { return (Float8)x; }

// Rounds towards zero; |x| < 2^31.
ODRAZ_INLINE int32_t toInt(float x) { return (int32_t)x; }
ODRAZ_INLINE Int8 toInt(Float8 x) { return (Int8)_mm256_cvttps_epi32(x); }
ODRAZ_INLINE float toFloat(int32_t x) { return (float)x; }
ODRAZ_INLINE Float8 toFloat(Int8 x) { return _mm256_cvtepi32_ps((__m256i)x); }

// --- Mixed operands, and functions of vectors only ---

ODRAZ_INLINE Float8 fmadd(Float8 a, float b, Float8 c) { return fmadd(a, broadcast(b), c); }
ODRAZ_INLINE Float8 fmadd(float a, Float8 b, Float8 c) { return fmadd(broadcast(a), b, c); }
ODRAZ_INLINE Float8 fmadd(Float8 a, float b, float c) { return fmadd(a, broadcast(b), broadcast(c)); }
ODRAZ_INLINE Float8 fmadd(Float8 a, Float8 b, float c) { return fmadd(a, b, broadcast(c)); }
ODRAZ_INLINE Float8 fmadd(float a, Float8 b, float c) { return fmadd(broadcast(a), b, broadcast(c)); }
ODRAZ_INLINE Float8 min(Float8 a, float b) { return min(a, broadcast(b)); }
ODRAZ_INLINE Float8 max(Float8 a, float b) { return max(a, broadcast(b)); }
ODRAZ_INLINE Float8 select(Int8 m, Float8 a, float b) { return select(m, a, broadcast(b)); }
ODRAZ_INLINE Float8 select(Int8 m, float a, Float8 b) { return select(m, broadcast(a), b); }
ODRAZ_INLINE Float8 select(Int8 m, float a, float b) { return select(m, broadcast(a), broadcast(b)); }

ODRAZ_INLINE int laneBits(Int8 m) { return _mm256_movemask_ps((Float8)m); }
ODRAZ_INLINE bool any(Int8 m) { return laneBits(m) != 0; }
ODRAZ_INLINE bool all(Int8 m) { return laneBits(m) == 255; }

ODRAZ_INLINE Float8 load(const float *p) { return _mm256_loadu_ps(p); }
ODRAZ_INLINE void store(float *p, Float8 x) { _mm256_storeu_ps(p, x); }
ODRAZ_INLINE Int8 loadInts(const int32_t *p) { return (Int8)_mm256_loadu_si256((const __m256i *)p); }
ODRAZ_INLINE void store(int32_t *p, Int8 x) { _mm256_storeu_si256((__m256i *)p, (__m256i)x); }
ODRAZ_INLINE Float8 gather(const float *base, Int8 index) {
    return _mm256_i32gather_ps(base, (__m256i)index, 4);
}

ODRAZ_INLINE float least(Float8 x) {
    Float8 m = min(x, (Float8)_mm256_permute2f128_ps(x, x, 1));
    m = min(m, (Float8)_mm256_permute_ps(m, 0x4e));
    return min(m, (Float8)_mm256_permute_ps(m, 0xb1))[0];
}

// Sums the lanes, always in the same order.
ODRAZ_INLINE float total(Float8 x) {
    Float8 s = x + (Float8)_mm256_permute2f128_ps(x, x, 1);
    s += (Float8)_mm256_permute_ps(s, 0x4e);
    return (s + (Float8)_mm256_permute_ps(s, 0xb1))[0];
}

template <class T> ODRAZ_INLINE T clamp(T x, float lo, float hi) { return min(max(x, lo), hi); }
ODRAZ_INLINE int clamp(int x, int lo, int hi) { return min(max(x, lo), hi); }
template <class T> ODRAZ_INLINE T saturate(T x) { return clamp(x, 0.f, 1.f); }

// Interpolates from a (t = 0) to b (t = 1).
template <class T, class S> auto lerp(const T &a, const T &b, S t) { return a + (b - a) * t; }

} // namespace odraz
