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

void makeToneCurve(ToneCurve &curve) {
    int32_t next = 0;
    for (int i = (int)(sizeof(curve.entry) / sizeof(*curve.entry)); i-- > 0;) {
        Float8 x = broadcast(fromBits(bits(ToneCurve::kFoot) + (i << ToneCurve::kShift)) - ToneCurve::kFoot);
        int32_t value = toInt(fmadd(encodeSrgb(filmic(x))[0], 255 * 128, 0.5f));
        curve.entry[i] = value << 16 | ((next - value) & 0xffff);
        next = value;
    }
}

namespace {

// Keeps x in a register or on the stack. Otherwise a loop makes the constant again, in 1 to 3 instructions.
template <class T> ODRAZ_INLINE T kept(T x) {
#ifndef __wasm__ // WebAssembly has no registers
    asm("" : "+x"(x));
#endif
    return x;
}

// Looks up eight entries of a curve, by the bits of values, one by one. On processors with the mitigation
// against Downfall, a gather instruction takes 1.5 times as long as all other work on a pixel.
ODRAZ_INLINE Int8 lookUp(const int32_t *entries, Int8 values) {
    const size_t kFirst = bits(ToneCurve::kFoot) >> ToneCurve::kShift;
    alignas(32) int32_t at[8];
    store(at, values >> ToneCurve::kShift);
    asm("" : "+m"(at)); // indices in registers would take two more instructions each
    auto entry = [&](int k) { return entries[(uint32_t)at[k] - kFirst]; };
    auto four = [&](int k) {
        __m128i v = _mm_cvtsi32_si128(entry(k));
        v = _mm_insert_epi32(v, entry(k + 1), 1);
        v = _mm_insert_epi32(v, entry(k + 2), 2);
        return _mm_insert_epi32(v, entry(k + 3), 3);
    };
    return (Int8)_mm256_set_m128i(four(4), four(0));
}

// The tone curve at eight values, with its constants in registers.
struct ToneLookUp {
    const int32_t *entries;
    Float8 foot = kept(broadcast(ToneCurve::kFoot)), head = kept(broadcast(ToneCurve::kHead));
    Int8 low14 = kept(broadcast(0x3fff)), one = kept(broadcast(1 << 30));
    // Returns the curve at v * gain in 2^-21 of one of the 255 steps.
    ODRAZ_INLINE Int8 at(Float8 v, Float8 gain) const {
        // Clamp to the table's range; NaN becomes 0
        v = min(max(fmadd(v, gain, foot), foot), head);
        // Interpolate: the entry's value times 2^14, plus the difference to the next one times the 14 bits
        // that follow the index
        Int8 share = (bits(v) >> (ToneCurve::kShift - 14) & low14) | one;
        return (Int8)_mm256_madd_epi16((__m256i)lookUp(entries, bits(v)), (__m256i)share);
    }
};

// Film grain: the sum of two random signed 16-bit numbers, times an amplitude.
struct Grain {
    Int8 amplitude, half, signs = kept(broadcast((int32_t)0x80008000));
    ODRAZ_INLINE Int8 at(Uint8 noise) const {
        return (Int8)_mm256_madd_epi16((__m256i)((Int8)pcg(noise) ^ signs), (__m256i)amplitude) + half;
    }
};

// Interpolates eight pixels of a row from a level that is a quarter as wide and high.
struct GlareRow {
    const float *near[3], *far[3]; // the two nearest rows
    Float8 share;                  // weight of the far row

    GlareRow(const Glare::Level &l, int y) {
        // The centres of pixels are at odd eighths of the level's pixels
        int eighth = 2 * y - 3, row = eighth >> 3;
        share = broadcast((float)(eighth & 7) * 0.125f);
        ptrdiff_t a = (ptrdiff_t)max(row, 0) * l.stride, b = (ptrdiff_t)min(row + 1, l.height - 1) * l.stride;
        for (int c = 0; c < 3; ++c) near[c] = l.plane[c] + a, far[c] = l.plane[c] + b;
    }
    ODRAZ_INLINE Float8 at(int c, ptrdiff_t x) const {
        const Float8 kWeight = {0.625f, 0.875f, 0.125f, 0.375f, 0.625f, 0.875f, 0.125f, 0.375f};
        const Int8 kFirst = {0, 0, 1, 1, 1, 1, 2, 2};
        Float8 v = load(near[c] + x / 4 - 1);
        v = fmadd(load(far[c] + x / 4 - 1) - v, share, v);
        Float8 first = _mm256_permutevar8x32_ps(v, (__m256i)kFirst),
               second = _mm256_permutevar8x32_ps(v, (__m256i)(kFirst + 1));
        return fmadd(second - first, kWeight, first);
    }
};

// Clamps eight pixels to the brightest of their neighbours, which are at these offsets. A pixel brighter than
// all of them is mostly a sample that hit something thin by chance, which the next picture will not show.
ODRAZ_INLINE Float8 withoutSparks(const float *at, ptrdiff_t left, ptrdiff_t right, ptrdiff_t above,
                                  ptrdiff_t below) {
    auto most = [&](const float *p) { return max(load(p + left), load(p + right)); };
    const float *up = at + above, *under = at + below;
    Float8 others = max(max(most(up), most(under)), max(load(up), load(under)));
    return min(max(most(at), others), load(at));
}

// Packs the colours of eight pixels to bytes, which clamps them to 0 .. 255, and writes them from x on.
ODRAZ_INLINE void write(uint8_t *out, const Int8 (&shown)[3], Int8 opaque, ptrdiff_t x, ptrdiff_t width) {
    const Int8 kOrder = {0x0c080400, 0x0d090501, 0x0e0a0602, 0x0f0b0703,
                         0x0c080400, 0x0d090501, 0x0e0a0602, 0x0f0b0703};
    __m256i pixels = _mm256_packus_epi16(_mm256_packs_epi32((__m256i)shown[0], (__m256i)shown[1]),
                                         _mm256_packs_epi32((__m256i)shown[2], (__m256i)opaque));
    pixels = _mm256_shuffle_epi8(pixels, (__m256i)kOrder);
    // Do not write beyond the row's end: another worker writes the next row
    if (x + 8 <= width)
        _mm256_storeu_si256((__m256i *)(out + x * 4), pixels);
    else
        _mm256_maskstore_epi32((int *)(out + x * 4), (__m256i)(kLanes < (int)(width - x)), pixels);
}

} // namespace

void develop(const ToneCurve &curve, Frame &frame, Workers &workers, float exposure, uint32_t seed,
             const Glare *glare, const CameraLook &look) {
    uint32_t salt = pcg(seed);
    const float midX = (float)frame.width * 0.5f, midY = (float)frame.height * 0.5f,
                darker = look.vignette / fmadd(midX, midX, midY * midY);
    auto rows = [&](int first, int end, int) __attribute__((flatten)) {
        // Copy these: through references, they would be loaded again after each write to the picture
        const Frame f = frame;
        const ToneLookUp tone = {curve.entry};
        const Grain grain = {kept(broadcast(look.grain * 0x10001)), kept(broadcast(look.grain))};
        const bool spread = glare;
        const Float8 fall = broadcast(-darker * exposure), spreadShare = broadcast(look.glare);
        const Uint8 salts = salt - Uint8{};
        const Int8 opaque = kept(broadcast(255)), eight = kept(broadcast(8));
        for (int y = first; y < end; ++y) {
            uint8_t *out = f.rgba + (size_t)y * (size_t)f.width * 4;
            float down = (float)y + 0.5f - midY;
            const Float8 rest = broadcast(fmadd(down * down, -darker, 1.f) * exposure);
            // At edges, use the opposite neighbour twice; in pictures of 1 row or 8 columns, the pixel itself
            ptrdiff_t below = y + 1 < f.height ? f.stride : -(ptrdiff_t)(y > 0) * f.stride,
                      above = y > 0 ? -f.stride : below, left = f.width > 8, row = (ptrdiff_t)y * f.stride;
            GlareRow glareRow(spread ? glare->level[1] : Glare::Level{}, y);
            Uint8 pixel = (Uint8)(kLanes + y * kMaxWidth);
            Float8 across = toFloat(kLanes) + (0.5f - midX);
            for (ptrdiff_t x = 0; x < f.width; x += 8) {
                Uint8 noise = pcg(pixel ^ salts);
                Int8 grains = grain.at(noise);
                Float8 gain = fmadd(across * across, fall, rest);
                ptrdiff_t right = x + 8 < f.width ? 1 : left;
                Int8 shown[3];
                for (int c = 0; c < 3; ++c) {
                    const float *at = f.plane[c] + (row + x);
                    Float8 v = withoutSparks(at, left, right, above, below);
                    if (spread) v = fmadd(glareRow.at(c, x) - v, spreadShare, v);
                    // Add noise: each colour has 10 random bits that no other colour uses
                    shown[c] = (tone.at(v, gain) + (Int8)(noise >> 11) + grains) >> 21;
                    noise <<= 10;
                }
                write(out, shown, opaque, x, f.width);
                left = -1;
                pixel += (Uint8)eight;
                across += 8;
            }
        }
    };
    parallelRanges(workers, frame.height, 16, rows);
}

} // namespace odraz
