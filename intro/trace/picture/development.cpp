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

// Looks up eight entries of a table, one by one. On processors with the mitigation against Downfall, one
// gather instruction takes half as long again as all other work on a pixel.
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

namespace {

// Interpolates eight pixels of a row from a level that is a quarter as wide and high.
struct GlareRow {
    const float *near[3], *far[3]; // the two nearest rows
    float share;                   // of the far one

    GlareRow(const Glare::Level &l, int y) {
        // The middles of pixels lie at odd eighths of the level's pixels
        int eighth = 2 * y - 3, row = eighth >> 3;
        share = (float)(eighth & 7) * 0.125f;
        ptrdiff_t a = (ptrdiff_t)max(row, 0) * l.stride, b = (ptrdiff_t)min(row + 1, l.height - 1) * l.stride;
        for (int c = 0; c < 3; ++c) near[c] = l.plane[c] + a, far[c] = l.plane[c] + b;
    }
    ODRAZ_INLINE Float8 at(int c, int x) const {
        const Float8 kWeight = {0.625f, 0.875f, 0.125f, 0.375f, 0.625f, 0.875f, 0.125f, 0.375f};
        const Int8 kFirst = {0, 0, 1, 1, 1, 1, 2, 2};
        Float8 v = load(near[c] + x / 4 - 1);
        v = fmadd(load(far[c] + x / 4 - 1) - v, share, v);
        Float8 first = _mm256_permutevar8x32_ps(v, (__m256i)kFirst),
               second = _mm256_permutevar8x32_ps(v, (__m256i)(kFirst + 1));
        return fmadd(second - first, kWeight, first);
    }
};

} // namespace

void develop(const Curve &curve, Frame &frame, Workers &workers, float exposure, uint32_t seed,
             const Glare *glare, const CameraLook &look) {
    uint32_t salt = pcg(seed);
    const float midX = (float)frame.width * 0.5f, midY = (float)frame.height * 0.5f,
                darker = look.vignette / fmadd(midX, midX, midY * midY);
    parallelRanges(workers, frame.height, 16, [&](int first, int end, int) {
        for (int y = first; y < end; ++y) {
            uint8_t *out = frame.rgba + (size_t)y * (size_t)frame.width * 4;
            float down = (float)y + 0.5f - midY, rest = fmadd(down * down, -darker, 1.f) * exposure;
            // At the picture's edges, neighbours are asked twice; in pictures of one row or of eight columns,
            // pixels themselves
            ptrdiff_t below = y + 1 < frame.height ? frame.stride : -(ptrdiff_t)(y > 0) * frame.stride,
                      above = y > 0 ? -frame.stride : below;
            GlareRow of(glare ? glare->level[1] : Glare::Level{}, y);
            for (int x = 0; x < frame.width; x += 8) {
                Uint8 noise = pcg((Uint8)(kLanes + (x + y * kMaxWidth)) ^ salt), grain = pcg(noise);
                Int8 grains = ((Int8)((grain >> 16) + (grain & 0xffff)) - 0xffff) * look.grain;
                Int8 pixels = broadcast((int32_t)0xff000000);
                Float8 aside = toFloat(kLanes) + ((float)x + 0.5f - midX),
                       gain = fmadd(aside * aside, -darker * exposure, rest);
                ptrdiff_t right = x + 8 < frame.width ? 1 : -(ptrdiff_t)(x > 0), left = x > 0 ? -1 : right;
                for (int c = 0; c < 3; ++c) {
                    const float *at = frame.plane[c] + (size_t)y * (size_t)frame.stride + x;
                    // What is brighter than all of its neighbours is mostly a sample that met something thin
                    // by chance, which the next picture lacks
                    auto most = [&](const float *p) { return max(load(p + left), load(p + right)); };
                    const float *up = at + above, *under = at + below;
                    Float8 beside = max(max(most(up), most(under)), max(load(up), load(under)));
                    Float8 v = min(max(most(at), beside), load(at));
                    if (glare) v = fmadd(of.at(c, x) - v, look.glare, v);
                    // NaN becomes the first entry
                    v = clamp(fmadd(v, gain, Curve::kFoot), Curve::kFoot, Curve::kHead);
                    Int8 entry = bits(v) - bits(Curve::kFoot);
                    Int8 place = lookUp(curve.place, entry >> Curve::kShift);
                    // The value times 2^14, plus the difference to the next one times the 14 bits that follow
                    // the index
                    Int8 share = (entry >> (Curve::kShift - 14) & 0x3fff) | 1 << 30;
                    Int8 shown = (Int8)_mm256_madd_epi16((__m256i)place, (__m256i)share);
                    // Each colour has its own noise: 10 bits that no other one uses
                    shown += (Int8)(noise >> 11);
                    shown = (Int8)_mm256_max_epi32((__m256i)(shown + grains), __m256i{});
                    pixels |= (Int8)_mm256_min_epi32((__m256i)(shown >> 21), (__m256i)broadcast(255))
                              << (8 * c);
                    noise <<= 10;
                }
                // Do not write beyond the row's end: another worker writes the next row
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
