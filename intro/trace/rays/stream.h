// Streams of rays, as structures of arrays. Rays are read from a stream eight at a time, from any places;
// those that go on are packed and appended to the next one.
#pragma once

#include "trace/scene/surface.h"

namespace odraz {

inline constexpr int kChunk = 256;             // rays shaded together
inline constexpr int kStream = 2 * kChunk + 8; // each ray may leave two; stores write whole registers

inline constexpr int kTwice = 4; // paths from here on bounced more than once, or at glass

struct RayStream {
    int count;
    float o[3][kStream], d[3][kStream];    // origin, unit direction
    float weight[3][kStream];              // how much of the ray's light the sample gets, per channel
    float width[kStream], spread[kStream]; // of the sample at the origin; growth per unit of distance
    int32_t sample[kStream];               // index of the Sample it adds to
    // A 1, then a bit for every bounce: 0 reflected, 1 refracted; 10 reflected by glass. 32 bits are kept
    int32_t path[kStream];
    float t[kStream];       // distance of the hit
    int32_t shape[kStream]; // the shape that it hit; -1: none
};

// Eight places of a stream. Mostly they are consecutive; then they are loaded instead of gathered.
struct Eight {
    Int8 place;
    int first;
    bool straight;

    explicit Eight(const int32_t *places) {
        place = loadInts(places);
        first = places[0];
        straight = all(place == kLanes + first);
    }
    ODRAZ_INLINE Float8 operator()(const float *values) const {
        return straight ? load(values + first) : gather(values, place);
    }
    ODRAZ_INLINE Int8 operator()(const int32_t *values) const {
        return straight ? loadInts(values + first) : (Int8)_mm256_i32gather_epi32(values, (__m256i)place, 4);
    }
    ODRAZ_INLINE Vec3x8 operator()(const float (&values)[3][kStream]) const {
        if (straight) return load(values, first);
        return {gather(values[0], place), gather(values[1], place), gather(values[2], place)};
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
