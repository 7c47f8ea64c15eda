#include "trace/picture/enlarge.h"

#include "base/float8.h"

#include <stddef.h>

namespace odraz {

namespace {

constexpr int kBand = 32; // rows of the larger picture that are made at a time

// The taps of eight values of an enlarged line: for each value the index of the first of four neighbouring
// pixels, and their weights in 64ths, a byte each.
struct Taps {
    Int8 first, weights;
};
// Computes the taps of values i; values are `step` pixels apart.
[[gnu::noinline]] Taps tapsOf(Int8 i, float step, int length) {
    Float8 at = clamp(fmadd(toFloat(i) + 0.5f, step, -0.5f), 1.f, (float)(length - 3)), whole = floor(at),
           t = at - whole;
    // Round the sums of the first one, two and three weights, so that the weights still sum to 64
    auto sum = [&](float a, float b, float c, float d) {
        Float8 v = fmadd(t, fmadd(t, fmadd(t, a, broadcast(b)), c), d);
        return (Int8)_mm256_cvtps_epi32(v);
    };
    Int8 one = sum(-32, 64, -32, 0), two = sum(64, -96, -32, 64), three = sum(-32, 32, 0, 64);
    return {toInt(whole) - 1,
            (one & 255) | ((two - one) & 255) << 8 | ((three - two) & 255) << 16 | (64 - three) << 24};
}

// Mixes eight pixels, each from four that are `step` bytes apart; for pixel k, the first is from[which[k]].
[[gnu::noinline]] void mix(const uint8_t *from, ptrdiff_t step, Int8 which, Int8 weights, uint8_t *out) {
    const __m256i forBytes =
        _mm256_broadcastsi128_si256(_mm_set_epi64x(0x0504050405040504, 0x0100010001000100));
    auto tap = [&] {
        __m256i v = _mm256_permutevar8x32_epi32(_mm256_loadu_si256((const __m256i *)from), (__m256i)which);
        from += step;
        return v;
    };
    __m256i a = tap(), b = tap(), c = tap(), d = tap();
    // Sum products, for the first two pixels of each four, then for the others
    auto half = [&](__m256i ab, __m256i cd, Int8 w) {
        auto products = [&](__m256i v, Int8 w) {
            return _mm256_maddubs_epi16(v, _mm256_shuffle_epi8((__m256i)w, forBytes));
        };
        __m256i sum = _mm256_add_epi16(products(ab, w), products(cd, w >> 16));
        return _mm256_srai_epi16(_mm256_add_epi16(sum, _mm256_set1_epi16(32)), 6);
    };
    __m256i mixed = _mm256_packus_epi16(half(_mm256_unpacklo_epi8(a, b), _mm256_unpacklo_epi8(c, d), weights),
                                        half(_mm256_unpackhi_epi8(a, b), _mm256_unpackhi_epi8(c, d),
                                             (Int8)_mm256_srli_si256((__m256i)weights, 8)));
    mixed = _mm256_max_epu8(mixed, _mm256_min_epu8(b, c));
    mixed = _mm256_min_epu8(mixed, _mm256_max_epu8(b, c));
    _mm256_storeu_si256((__m256i *)out, mixed);
}

} // namespace

void enlarge(const uint8_t *from, int width, int height, uint8_t *to, int toWidth, int toHeight,
             Workers &workers) {
    float across = (float)width / (float)toWidth, down = (float)height / (float)toHeight;
    parallelRanges(workers, toHeight, kBand, [=](int begin, int end, int) {
        // First enlarge the rows of `from` that this band needs to the full width
        uint8_t wide[kBand + 4][(kMostAcross + 8) * 4];
        int top = tapsOf(broadcast(begin), down, height).first[0],
            bottom = tapsOf(broadcast(end - 1), down, height).first[0] + 3;
        for (int x = 0; x < toWidth; x += 8) {
            // `from` is no wider than `to`, so the first taps of eight values are within eight of its pixels
            Taps taps = tapsOf(kLanes + x, across, width);
            int first = taps.first[0];
            for (int y = top; y <= bottom; ++y)
                mix(from + ((ptrdiff_t)y * width + first) * 4, 4, taps.first - first, taps.weights,
                    wide[y - top] + x * 4);
        }
        for (int y = begin; y < end; ++y) {
            Taps taps = tapsOf(broadcast(y), down, height);
            for (int x = 0; x < toWidth; x += 8) {
                // The last eight pixels may overlap those before them
                int at = min(x, toWidth - 8) * 4;
                mix(wide[taps.first[0] - top] + at, sizeof *wide, kLanes, taps.weights,
                    to + (ptrdiff_t)y * toWidth * 4 + at);
            }
        }
    });
}

} // namespace odraz
