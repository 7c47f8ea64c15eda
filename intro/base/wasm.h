// The instructions of base/avx.h for WebAssembly. Each one computes two halves of 128 bits, with SIMD and
// relaxed SIMD.
//
// A multiply-add is fused wherever the processor can fuse it (every ARM, x86-64 since 2013). On other
// processors, and for NaN and numbers out of range, the results of two browsers may differ.
#pragma once

#include <stddef.h>
#include <stdint.h>
#include <wasm_simd128.h>

using __m128 = float __attribute__((vector_size(16)));
using __m128i = long long __attribute__((vector_size(16)));
using __m256 = float __attribute__((vector_size(32)));
using __m256i = long long __attribute__((vector_size(32)));
using __m256d = double __attribute__((vector_size(32)));

namespace odraz::wasm {

#define ODRAZ_W [[gnu::always_inline, maybe_unused]] static inline

using F4 = __m128;
using F8 = __m256;
using I4 = int32_t __attribute__((vector_size(16)));
using I8 = int32_t __attribute__((vector_size(32)));
using S8 = int16_t __attribute__((vector_size(16)));
using S16 = int16_t __attribute__((vector_size(32)));
using B16 = uint8_t __attribute__((vector_size(16)));
using B32 = uint8_t __attribute__((vector_size(32)));
using D4 = double __attribute__((vector_size(32)));
using L4 = long long __attribute__((vector_size(32)));

template <class T> ODRAZ_W F4 low(T x) {
    F8 v = (F8)x;
    return __builtin_shufflevector(v, v, 0, 1, 2, 3);
}
template <class T> ODRAZ_W F4 high(T x) {
    F8 v = (F8)x;
    return __builtin_shufflevector(v, v, 4, 5, 6, 7);
}
template <class T> ODRAZ_W F8 join(T a, T b) {
    return __builtin_shufflevector((F4)a, (F4)b, 0, 1, 2, 3, 4, 5, 6, 7);
}
template <class F> ODRAZ_W F8 both(F8 a, const F &f) { return join((F4)f(low(a)), (F4)f(high(a))); }
template <class F> ODRAZ_W F8 both(F8 a, F8 b, const F &f) {
    return join((F4)f(low(a), low(b)), (F4)f(high(a), high(b)));
}
template <class F> ODRAZ_W F8 both(F8 a, F8 b, F8 c, const F &f) {
    return join((F4)f(low(a), low(b), low(c)), (F4)f(high(a), high(b), high(c)));
}
// The same, for functions of <wasm_simd128.h>
template <class T, class F> ODRAZ_W T bothV128(T a, T b, const F &f) {
    return (T)join((F4)f((v128_t)low(a), (v128_t)low(b)), (F4)f((v128_t)high(a), (v128_t)high(b)));
}
template <class T, class P> ODRAZ_W T read(const P *p) {
    T v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
template <class T, class P> ODRAZ_W void write(P *p, T v) { __builtin_memcpy(p, &v, sizeof v); }

#ifdef __wasm_relaxed_simd__
ODRAZ_W F4 madd(F4 a, F4 b, F4 c) { return (F4)__builtin_wasm_relaxed_madd_f32x4(a, b, c); }
ODRAZ_W F4 blend(F4 a, F4 b, F4 m) {
    return (F4)__builtin_wasm_relaxed_laneselect_i32x4((I4)b, (I4)a, (I4)m);
}
ODRAZ_W F4 truncated(F4 x) { return (F4)__builtin_wasm_relaxed_trunc_s_i32x4_f32x4(x); }
#else // rounded twice: pictures differ
ODRAZ_W F4 madd(F4 a, F4 b, F4 c) { return a * b + c; }
ODRAZ_W F4 blend(F4 a, F4 b, F4 m) { return (F4)wasm_v128_bitselect((v128_t)b, (v128_t)a, (v128_t)m); }
ODRAZ_W F4 truncated(F4 x) { return (F4)wasm_i32x4_trunc_sat_f32x4((v128_t)x); }
#endif
// Minimum and maximum; the second operand if one is NaN
ODRAZ_W F4 min4(F4 a, F4 b) { return (F4)__builtin_wasm_pmin_f32x4(b, a); }
ODRAZ_W F4 max4(F4 a, F4 b) { return (F4)__builtin_wasm_pmax_f32x4(b, a); }
ODRAZ_W int signs(F4 a) { return (int)__builtin_wasm_bitmask_i32x4((I4)a); }

} // namespace odraz::wasm

// clang-format off
#define W odraz::wasm::
// --- Eight floats ---
ODRAZ_W __m256 _mm256_fmadd_ps(__m256 a, __m256 b, __m256 c) { return W both(a, b, c, W madd); }
ODRAZ_W __m256 _mm256_fmsub_ps(__m256 a, __m256 b, __m256 c) { return W both(a, b, -c, W madd); }
ODRAZ_W __m256 _mm256_sqrt_ps(__m256 a) { return W both(a, [](W F4 x) { return wasm_f32x4_sqrt((v128_t)x); }); }
ODRAZ_W __m256 _mm256_floor_ps(__m256 a) { return W both(a, [](W F4 x) { return wasm_f32x4_floor((v128_t)x); }); }
#define _MM_FROUND_TO_NEAREST_INT 0
#define _MM_FROUND_NO_EXC 8
ODRAZ_W __m256 _mm256_round_ps(__m256 a, int) {
    return W both(a, [](W F4 x) { return wasm_f32x4_nearest((v128_t)x); });
}
ODRAZ_W __m256 _mm256_min_ps(__m256 a, __m256 b) { return W both(a, b, W min4); }
ODRAZ_W __m256 _mm256_max_ps(__m256 a, __m256 b) { return W both(a, b, W max4); }
ODRAZ_W __m256 _mm256_blendv_ps(__m256 a, __m256 b, __m256 m) {
    return W both(a, b, m, W blend);
}
ODRAZ_W int _mm256_movemask_ps(__m256 a) { return W signs(W low(a)) | W signs(W high(a)) << 4; }
ODRAZ_W __m256i _mm256_cvttps_epi32(__m256 a) {
    return (__m256i)W both(a, W truncated);
}
ODRAZ_W __m256i _mm256_cvtps_epi32(__m256 a) { return _mm256_cvttps_epi32(_mm256_round_ps(a, 0)); }
ODRAZ_W __m256 _mm256_cvtepi32_ps(__m256i a) { return __builtin_convertvector((W I8)a, W F8); }
ODRAZ_W __m256 _mm256_loadu_ps(const float *p) { return W read<__m256>(p); }
ODRAZ_W void _mm256_storeu_ps(float *p, __m256 v) { W write(p, v); }
ODRAZ_W __m256i _mm256_loadu_si256(const __m256i *p) { return W read<__m256i>(p); }
ODRAZ_W void _mm256_storeu_si256(__m256i *p, __m256i v) { W write(p, v); }
ODRAZ_W __m256i _mm256_i32gather_epi32(const int *p, __m256i at, int) {
    W I8 i = (W I8)at;
    return (__m256i)W I8{p[i[0]], p[i[1]], p[i[2]], p[i[3]], p[i[4]], p[i[5]], p[i[6]], p[i[7]]};
}
ODRAZ_W __m256 _mm256_i32gather_ps(const float *p, __m256i at, int) {
    W I8 i = (W I8)at;
    return W F8{p[i[0]], p[i[1]], p[i[2]], p[i[3]], p[i[4]], p[i[5]], p[i[6]], p[i[7]]};
}
// Stores the lanes of the mask, and writes the others back unchanged
ODRAZ_W void _mm256_maskstore_ps(float *p, __m256i m, __m256 v) {
    W write(p, _mm256_blendv_ps(W read<__m256>(p), v, (__m256)m));
}
ODRAZ_W void _mm256_maskstore_epi32(int *p, __m256i m, __m256i v) { _mm256_maskstore_ps((float *)p, m, (__m256)v); }

// --- Permutations ---
ODRAZ_W W F4 half_(__m256 a, __m256 b, int k) {
    return k == 0 ? W low(a) : k == 1 ? W high(a) : k == 2 ? W low(b) : W high(b);
}
ODRAZ_W __m256 _mm256_permute2f128_ps(__m256 a, __m256 b, int k) {
    return W join(half_(a, b, k & 3), half_(a, b, k >> 4 & 3));
}
// k is a constant with two bits for each lane
#define _mm256_permute_ps(a, k) \
    __builtin_shufflevector((__m256)(a), (__m256)(a), (k) & 3, (k) >> 2 & 3, (k) >> 4 & 3, (k) >> 6 & 3, \
                            ((k) & 3) + 4, ((k) >> 2 & 3) + 4, ((k) >> 4 & 3) + 4, ((k) >> 6 & 3) + 4)
#define _mm256_shuffle_ps(a, b, k) \
    __builtin_shufflevector((__m256)(a), (__m256)(b), (k) & 3, (k) >> 2 & 3, ((k) >> 4 & 3) + 8, ((k) >> 6 & 3) + 8, \
                            ((k) & 3) + 4, ((k) >> 2 & 3) + 4, ((k) >> 4 & 3) + 12, ((k) >> 6 & 3) + 12)
ODRAZ_W __m256i _mm256_permutevar8x32_epi32(__m256i a, __m256i at) {
    // Offsets of bytes; a swizzle gives 0 for offsets beyond 15
    W I8 bytes = ((W I8)at & 7) * 0x04040404 + 0x03020100;
    auto pick = [&](W F4 which) {
        W B16 w = (W B16)which;
        return (W F4)(wasm_i8x16_swizzle((v128_t)W low(a), (v128_t)w) |
                      wasm_i8x16_swizzle((v128_t)W high(a), (v128_t)(w - 16)));
    };
    return (__m256i)W both((__m256)bytes, pick);
}
ODRAZ_W __m256 _mm256_permutevar8x32_ps(__m256 a, __m256i at) {
    return (__m256)_mm256_permutevar8x32_epi32((__m256i)a, at);
}
ODRAZ_W __m256 _mm256_unpacklo_ps(__m256 a, __m256 b) {
    return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
}
ODRAZ_W __m256 _mm256_unpackhi_ps(__m256 a, __m256 b) {
    return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
}
ODRAZ_W __m256 _mm256_hadd_ps(__m256 a, __m256 b) {
    return __builtin_shufflevector(a, b, 0, 2, 8, 10, 4, 6, 12, 14) +
            __builtin_shufflevector(a, b, 1, 3, 9, 11, 5, 7, 13, 15);
}
ODRAZ_W __m256 _mm256_addsub_ps(__m256 a, __m256 b) {
    return a + (__m256)((W I8)b ^ W I8{INT32_MIN, 0, INT32_MIN, 0, INT32_MIN, 0, INT32_MIN, 0});
}
ODRAZ_W __m256d _mm256_castps_pd(__m256 a) { return (__m256d)a; }
ODRAZ_W __m256 _mm256_castpd_ps(__m256d a) { return (__m256)a; }
ODRAZ_W __m256d _mm256_permute4x64_pd(__m256d a, int) { return __builtin_shufflevector(a, a, 0, 2, 1, 3); } // 0xd8 only
ODRAZ_W __m128 _mm256_castps256_ps128(__m256 a) { return W low(a); }
ODRAZ_W __m128 _mm256_extractf128_ps(__m256 a, int k) { return k ? W high(a) : W low(a); }
ODRAZ_W __m256 _mm256_set_m128(__m128 high, __m128 low) { return W join(low, high); }

// --- Integers ---
ODRAZ_W __m256i _mm256_set_m128i(__m128i high, __m128i low) { return (__m256i)W join(low, high); }
ODRAZ_W __m256i _mm256_broadcastsi128_si256(__m128i a) { return (__m256i)W join(a, a); }
ODRAZ_W __m256i _mm256_max_epu8(__m256i a, __m256i b) { return (__m256i)__builtin_elementwise_max((W B32)a, (W B32)b); }
ODRAZ_W __m256i _mm256_min_epu8(__m256i a, __m256i b) { return (__m256i)__builtin_elementwise_min((W B32)a, (W B32)b); }
ODRAZ_W __m256i _mm256_add_epi16(__m256i a, __m256i b) { return (__m256i)((W S16)a + (W S16)b); }
ODRAZ_W __m256i _mm256_srai_epi16(__m256i a, int k) { return (__m256i)((W S16)a >> (int16_t)k); }
ODRAZ_W __m256i _mm256_set1_epi16(short x) { return (__m256i)(x - W S16{}); }
ODRAZ_W __m256i _mm256_madd_epi16(__m256i a, __m256i b) {
    return W bothV128(a, b, wasm_i32x4_dot_i16x8);
}
// Without saturation, which no caller needs
ODRAZ_W __m256i _mm256_maddubs_epi16(__m256i a, __m256i b) {
    W S16 even = ((W S16)a & 255) * ((W S16)((W S16)b << (int16_t)8) >> (int16_t)8);
    using U16 = uint16_t __attribute__((vector_size(32)));
    return (__m256i)(even + (W S16)((U16)a >> (uint16_t)8) * ((W S16)b >> (int16_t)8));
}
ODRAZ_W __m256i _mm256_packus_epi16(__m256i a, __m256i b) {
    return W bothV128(a, b, wasm_u8x16_narrow_i16x8);
}
ODRAZ_W __m256i _mm256_shuffle_epi8(__m256i a, __m256i at) {
    return W bothV128(a, at, wasm_i8x16_swizzle);
}
ODRAZ_W __m256i _mm256_unpacklo_epi8(__m256i a, __m256i b) {
    return (__m256i)W both((__m256)a, (__m256)b, [](W F4 a, W F4 b) {
        return (W F4)__builtin_shufflevector((W B16)a, (W B16)b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20,
            5, 21, 6, 22, 7, 23); });
}
ODRAZ_W __m256i _mm256_unpackhi_epi8(__m256i a, __m256i b) {
    return (__m256i)W both((__m256)a, (__m256)b, [](W F4 a, W F4 b) {
        return (W F4)__builtin_shufflevector((W B16)a, (W B16)b, 8, 24, 9, 25, 10, 26, 11, 27, 12,
            28, 13, 29, 14, 30, 15, 31); });
}
ODRAZ_W __m256i _mm256_srli_si256(__m256i a, int) { // by 8 only
    W L4 v = (W L4)a;
    return __builtin_shufflevector(v, W L4{}, 1, 4, 3, 4);
}
ODRAZ_W __m256i _mm256_cvtepu16_epi32(__m128i a) {
    using U8 = uint16_t __attribute__((vector_size(16)));
    return (__m256i)__builtin_convertvector((U8)a, W I8);
}

ODRAZ_W __m256i _mm256_packs_epi32(__m256i a, __m256i b) {
    return W bothV128(a, b, wasm_i16x8_narrow_i32x4);
}

// --- Vectors of 128 bits ---
ODRAZ_W __m128 _mm_set_ss(float x) { return __m128{x, 0, 0, 0}; }
ODRAZ_W float _mm_cvtss_f32(__m128 a) { return a[0]; }
ODRAZ_W __m128 _mm_round_ss(__m128, __m128 b, int) { return __m128{__builtin_rintf(b[0]), 0, 0, 0}; }
ODRAZ_W __m128 _mm_set1_ps(float x) { return x - __m128{}; }
ODRAZ_W __m128 _mm_setzero_ps() { return __m128{}; }
ODRAZ_W __m128 _mm_load_ps(const float *p) { return W read<__m128>(p); }
ODRAZ_W __m128 _mm_loadu_ps(const float *p) { return W read<__m128>(p); }
ODRAZ_W void _mm_store_ps(float *p, __m128 v) { W write(p, v); }
ODRAZ_W __m128 _mm_min_ps(__m128 a, __m128 b) { return W min4(a, b); }
ODRAZ_W __m128 _mm_max_ps(__m128 a, __m128 b) { return W max4(a, b); }
ODRAZ_W __m128 _mm_sqrt_ps(__m128 a) { return (__m128)wasm_f32x4_sqrt((v128_t)a); }
ODRAZ_W __m128 _mm_cmpgt_ps(__m128 a, __m128 b) { return (__m128)(a > b); }
ODRAZ_W int _mm_movemask_ps(__m128 a) { return W signs(a); }
ODRAZ_W __m128 _mm_blend_ps(__m128 a, __m128 b, int) { return __builtin_shufflevector(a, b, 0, 1, 2, 7); } // 8 only
ODRAZ_W __m128 _mm_castsi128_ps(__m128i a) { return (__m128)a; }
ODRAZ_W __m128i _mm_castps_si128(__m128 a) { return (__m128i)a; }
ODRAZ_W __m128i _mm_setr_epi32(int a, int b, int c, int d) { return (__m128i)W I4{a, b, c, d}; }
ODRAZ_W __m128i _mm_set_epi64x(long long high, long long low) { return __m128i{low, high}; }
ODRAZ_W __m128i _mm_set1_epi16(short x) { return (__m128i)(x - W S8{}); }
ODRAZ_W __m128i _mm_or_si128(__m128i a, __m128i b) { return a | b; }
ODRAZ_W __m128i _mm_and_si128(__m128i a, __m128i b) { return a & b; }
ODRAZ_W __m128i _mm_cmpeq_epi32(__m128i a, __m128i b) { return (__m128i)((W I4)a == (W I4)b); }
ODRAZ_W __m128i _mm_add_epi32(__m128i a, __m128i b) { return (__m128i)((W I4)a + (W I4)b); }
ODRAZ_W __m128i _mm_loadu_si128(const __m128i *p) { return W read<__m128i>(p); }
ODRAZ_W void _mm_storeu_si128(__m128i *p, __m128i v) { W write(p, v); }
ODRAZ_W void _mm_storel_epi64(__m128i *p, __m128i v) { W write(p, (long long)v[0]); }
ODRAZ_W void _mm_storeu_si32(void *p, __m128i v) { W write((char *)p, ((W I4)v)[0]); }
ODRAZ_W __m128i _mm_cvtsi32_si128(int x) { return (__m128i)W I4{x, 0, 0, 0}; }
ODRAZ_W __m128i _mm_insert_epi32(__m128i a, int x, int k) { W I4 v = (W I4)a; v[k] = x; return (__m128i)v; }
ODRAZ_W int _mm_extract_epi32(__m128i a, int k) { return ((W I4)a)[k]; }
ODRAZ_W unsigned _mm_getcsr() { return 0; } // WebAssembly never flushes denormal numbers to zero
ODRAZ_W void _mm_setcsr(unsigned) {}
#undef W
// clang-format on
