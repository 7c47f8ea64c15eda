// Streams of rays, as structures of arrays. Rays are read from a stream eight at a time, by any indices. The
// rays that they cause are packed and appended to the next stream.
#pragma once

#include "trace/scene/surface.h"

namespace odraz {

inline constexpr int kChunk = 256;             // rays shaded together
inline constexpr int kStream = 2 * kChunk + 8; // each ray may cause two; stores write whole registers

inline constexpr int kTwoBounces = 4; // paths >= this have two bounces or a reflection by glass

struct RayStream {
    int count;
    float o[3][kStream], d[3][kStream];    // origin, unit direction
    float weight[3][kStream];              // share of the ray's light that the sample gets, per channel
    float width[kStream], spread[kStream]; // the sample's width at the origin; its growth per unit
    int32_t sample[kStream];               // index of the Sample to which the ray adds
    // A 1, then for every bounce 0 (reflected), 1 (refracted) or 10 (reflected by glass); the last 32 bits
    int32_t path[kStream];
    float t[kStream];       // distance of the hit
    int32_t shape[kStream]; // index of the shape hit; -1: none
};

// Reads eight rays of a stream by their indices. Consecutive rays, as most are, are not gathered but loaded.
struct EightRays {
    Int8 index;
    int first;
    bool consecutive;

    explicit EightRays(const int32_t *indices) {
        index = loadInts(indices);
        first = indices[0];
        consecutive = all(index == kLanes + first);
    }
    ODRAZ_INLINE Float8 operator()(const float *values) const {
        return consecutive ? load(values + first) : gather(values, index);
    }
    ODRAZ_INLINE Int8 operator()(const int32_t *values) const {
        return consecutive ? loadInts(values + first)
                           : (Int8)_mm256_i32gather_epi32(values, (__m256i)index, 4);
    }
    ODRAZ_INLINE Vec3x8 operator()(const float (&values)[3][kStream]) const {
        if (consecutive) return load(values, first);
        return {gather(values[0], index), gather(values[1], index), gather(values[2], index)};
    }
};

// The permutation that moves the lanes of a mask to the front.
#ifdef __wasm__
struct PackedOrders {
    uint64_t order[256] = {};
    constexpr PackedOrders() {
        for (int mask = 0; mask < 256; ++mask)
            for (int lane = 0, n = 0; lane < 8; ++lane)
                if (mask >> lane & 1) order[mask] |= (uint64_t)lane << 8 * n++;
    }
};
inline constexpr PackedOrders kPackedOrders;
ODRAZ_INLINE Int8 packedOrder(int mask) {
    using Bytes = uint8_t __attribute__((vector_size(8)));
    return __builtin_convertvector((Bytes)kPackedOrders.order[mask], Int8);
}
#else
ODRAZ_INLINE Int8 packedOrder(int mask) {
    uint64_t bytes = _pdep_u64((uint64_t)mask, 0x0101010101010101) * 255;
    uint64_t order = _pext_u64(0x0706050403020100, bytes);
    return (Int8)_mm256_cvtepu8_epi32(_mm_cvtsi64_si128((int64_t)order));
}
#endif
ODRAZ_INLINE Float8 permute(Float8 v, Int8 order) { return _mm256_permutevar8x32_ps(v, (__m256i)order); }
ODRAZ_INLINE Int8 permute(Int8 v, Int8 order) { return (Int8)permute((Float8)v, order); }

} // namespace odraz
