// Samples: what is traced at a point of the picture, and the marks by which neighbours are compared.
#pragma once

#include "trace/scene/scene.h"

#include <stddef.h>

namespace odraz {

// The number of a hit, for one hit or for eight. It is never 0, which means the sky.
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
    Rgb rest;        // highlights, emission, sky, and all that secondary rays brought
    uint32_t secondary; // sum of hashes of what every secondary ray hit, and of the texture cell there

    uint32_t shape() const { return unpackShape(id); } // where id != 0
    Rgb radiance() const { return albedo * light + rest; }
};
// A colour of a sample as four floats. The last one is 0: the mark that is stored there would act as a
// denormal number, and those cost a hundred cycles.
ODRAZ_INLINE __m128 fourOf(const Rgb &c) { return _mm_blend_ps(_mm_load_ps(&c.x), _mm_setzero_ps(), 8); }
ODRAZ_INLINE __m128 radianceOf(const Sample &s) {
    return fourOf(s.albedo) * fourOf(s.light) + fourOf(s.rest);
}

// Where samples are written: whole, or only their radiance, which takes less work; its fourth float is 0.
struct Samples {
    Sample *whole; // null: radiance alone
    float *rest;   // of the first sample, or its radiance
    int apart;     // floats from one sample's rest to the next one's

    Samples(Sample *s) : whole(s), rest(&s->rest.x), apart(sizeof(Sample) / sizeof(float)) {}
    Samples(__m128 *radiance) : whole(nullptr), rest((float *)radiance), apart(4) {}
    ODRAZ_INLINE float *restOf(int32_t i) const { return rest + (ptrdiff_t)i * apart; }
};

inline Rgb8 eightColours(const __m128 *v) {
    auto both = [&](int k) { return _mm256_set_m128(v[k + 4], v[k]); };
    __m256 a = both(0), b = both(1), c = both(2), d = both(3);
    __m256 abLow = _mm256_unpacklo_ps(a, b), cdLow = _mm256_unpacklo_ps(c, d);
    return {_mm256_shuffle_ps(abLow, cdLow, 0x44), _mm256_shuffle_ps(abLow, cdLow, 0xee),
            _mm256_shuffle_ps(_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d), 0x44)};
}

// Sample::lights holds the states of the lights in its low bits. From kCellShift on it holds the number of
// the patch, below 2^15, in scenes that show patches. kTextured is set where a secondary ray of some weight
// hit a texture, and near highlights, because the corners of a square do not show how much detail is there.
inline constexpr int kCellShift = 16;
inline constexpr uint32_t kTextured = 1u << 31;
static_assert(2 * kMaxLights <= kCellShift, "two bits a light");
// In these bits Sample::secondary counts the rays that bring mirrored lamps near; in hashes they are clear.
inline constexpr int kLamps = 7;

} // namespace odraz
