// Samples: the results at points of the picture, and the marks by which neighbouring samples are compared.
#pragma once

#include "trace/scene/scene.h"

#include <stddef.h>

namespace odraz {

// The number of a hit, from its shape and face; for one hit or for eight. It is never 0, which means the sky.
template <class Index, class Face> ODRAZ_INLINE auto packHit(Index shape, Face face) {
    return face + (shape * 8 + 1);
}
constexpr uint32_t unpackShape(uint32_t hit) { return (hit - 1) / 8; }
ODRAZ_INLINE Int8 unpackShape(Int8 hit) { return (hit - 1) >> 3; }

// The result of a primary ray: radiance = albedo * light + rest.
struct alignas(16) Sample {
    Rgb albedo;      // diffuse colour at the primary hit
    uint32_t id;     // primary hit: packHit(); 0: the sky
    Rgb light;       // diffuse light on it
    uint32_t lights; // two bits a light: 0 dark, 1 lit, 2 lit with a highlight, 3 dimmed by glass; kTextured
    Rgb rest;        // highlights, emission, sky, and all light from secondary rays
    uint32_t secondary; // sum of hashes of each secondary ray's hit and the texture cell there

    uint32_t shape() const { return unpackShape(id); } // only if id != 0
    Rgb radiance() const { return albedo * light + rest; }
};
// A colour of a sample as four floats. The last one is set to 0: the mark that is stored there would be a
// denormal number, which costs a hundred cycles in every operation.
ODRAZ_INLINE __m128 fourOf(const Rgb &c) { return _mm_blend_ps(_mm_load_ps(&c.x), _mm_setzero_ps(), 8); }
ODRAZ_INLINE __m128 radianceOf(const Sample &s) {
    return fourOf(s.albedo) * fourOf(s.light) + fourOf(s.rest);
}

// The samples to write: whole ones, or only their radiance, which takes less work; its fourth float is 0.
struct Samples {
    Sample *whole; // null: only radiance
    float *rest;   // the first sample's rest or radiance
    int stride;    // floats from one sample's rest to the next one's

    Samples(Sample *s) : whole(s), rest(&s->rest.x), stride(sizeof(Sample) / sizeof(float)) {}
    Samples(__m128 *radiance) : whole(nullptr), rest((float *)radiance), stride(4) {}
    ODRAZ_INLINE float *restOf(int32_t i) const { return rest + (ptrdiff_t)i * stride; }
};

inline Rgb8 eightColours(const __m128 *v) {
    auto both = [&](int k) { return _mm256_set_m128(v[k + 4], v[k]); };
    __m256 a = both(0), b = both(1), c = both(2), d = both(3);
    __m256 abLow = _mm256_unpacklo_ps(a, b), cdLow = _mm256_unpacklo_ps(c, d);
    return {_mm256_shuffle_ps(abLow, cdLow, 0x44), _mm256_shuffle_ps(abLow, cdLow, 0xee),
            _mm256_shuffle_ps(_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d), 0x44)};
}

// Sample::lights holds the states of the lights in its low bits. In scenes that show patches, the bits from
// kCellShift on hold the patch's number, below 2^15. kTextured is set where a secondary ray of some weight
// hit a texture, and near highlights, because corners do not show how much detail is between them.
inline constexpr int kCellShift = 16;
inline constexpr uint32_t kTextured = 1u << 31;
static_assert(2 * kMaxLights <= kCellShift, "two bits a light");
// In these bits Sample::secondary counts secondary rays that pass near lamps. In hashes these bits are clear.
inline constexpr int kLamps = 7;

} // namespace odraz
