#include "trace/picture/development.h"

#include "base/maths.h"
#include "base/random.h"

namespace odraz {

Float8 filmic(Float8 x) {
    x = clamp(x, 0.f, 1e6f);
    return x * fmadd(x, 2.51f, 0.03f) / fmadd(x, fmadd(x, 2.51f, 0.59f), 0.14f);
}

Float8 encodeSrgb(Float8 x) {
    return select(x <= 0.0031308f, x * 12.92f, fmadd(pow(x, 1 / 2.4f), 1.055f, -0.055f));
}

// Eight places of a table, one by one: where processors were mended against Downfall, their instruction for
// it takes half as long again as all the rest of a pixel.
static Int8 lookUp(const int32_t *table, Int8 index) {
    auto four = [&](__m128i at) {
        uint64_t low = (uint64_t)_mm_cvtsi128_si64(at), high = (uint64_t)_mm_extract_epi64(at, 1);
        __m128i v = _mm_cvtsi32_si128(table[(uint32_t)low]);
        v = _mm_insert_epi32(v, table[low >> 32], 1);
        v = _mm_insert_epi32(v, table[(uint32_t)high], 2);
        return _mm_insert_epi32(v, table[high >> 32], 3);
    };
    return (Int8)_mm256_set_m128i(four(_mm256_extracti128_si256((__m256i)index, 1)),
                                  four(_mm256_castsi256_si128((__m256i)index)));
}

void makeCurve(Curve &curve) {
    int32_t next = 0;
    for (int i = (int)(sizeof(curve.place) / sizeof(*curve.place)); i-- > 0;) {
        Float8 x = broadcast(fromBits(bits(Curve::kFoot) + (i << Curve::kShift)) - Curve::kFoot);
        int32_t value = toInt(fmadd(encodeSrgb(filmic(x))[0], 255 * 128, 0.5f));
        curve.place[i] = value << 16 | ((next - value) & 0xffff);
        next = value;
    }
}

void develop(const Curve &curve, Frame &frame, Workers &workers, float exposure, uint32_t seed) {
    uint32_t salt = pcg(seed);
    parallelRanges(workers, frame.height, 16, [&](int first, int end, int) {
        for (int y = first; y < end; ++y) {
            uint8_t *out = frame.rgba + (size_t)y * (size_t)frame.width * 4;
            for (int x = 0; x < frame.width; x += 8) {
                Uint8 noise = pcg((Uint8)(kLanes + (x + y * kMaxWidth)) ^ salt);
                Int8 pixels = broadcast((int32_t)0xff000000);
                for (int c = 0; c < 3; ++c) {
                    Float8 v = load(frame.plane[c] + (size_t)y * (size_t)frame.stride + x);
                    // NaN becomes the first place
                    v = clamp(fmadd(v, exposure, Curve::kFoot), Curve::kFoot, Curve::kHead);
                    Int8 at = bits(v) - bits(Curve::kFoot);
                    Int8 place = lookUp(curve.place, at >> Curve::kShift);
                    // The value times 2^14, and the way to the next times 14 bits of what is left of the
                    // place
                    Int8 share = (at >> (Curve::kShift - 14) & 0x3fff) | 1 << 30;
                    Uint8 shown = (Uint8)_mm256_madd_epi16((__m256i)place, (__m256i)share);
                    // Each colour has noise of its own, 10 bits that no other has
                    pixels |= (Int8)((shown + (noise >> 11)) >> 21) << (8 * c);
                    noise <<= 10;
                }
                // A row's end may not run over the next one's start, which another worker writes
                if (x + 8 <= frame.width)
                    _mm256_storeu_si256((__m256i *)(out + x * 4), (__m256i)pixels);
                else
                    for (int k = 0; k < frame.width - x; ++k)
                        for (int c = 0; c < 4; ++c) out[(x + k) * 4 + c] = (uint8_t)(pixels[k] >> (8 * c));
            }
        }
    });
}

} // namespace odraz
