#include "trace/picture/enlarge.h"

#include "base/float8.h"

namespace odraz {

namespace {

constexpr int kBand = 32; // rows of the larger picture that are made at a time

// The four neighbours in a line of pixels that a value of a longer line is made of: the first of them, and
// their weights in 64ths, a byte each.
struct Taps {
    int first, weights;
};
[[gnu::noinline]] Taps tapsAt(int i, float step, int length) {
    // Sums of the first weights, which are cubics: rounded, their differences still sum to 64
    const __m128 a = {-0.5f, 1, -0.5f, 0}, b = {1, -1.5f, 0.5f, 0}, c = {-0.5f, -0.5f, 0, 0},
                 d = {0, 1, 1, 1};
    float at = clamp(((float)i + 0.5f) * step - 0.5f, 1.f, (float)(length - 3));
    int whole = (int)at;
    float t = at - (float)whole;
    __m128i w = _mm_cvtps_epi32((((a * t + b) * t + c) * t + d) * 64);
    w = _mm_sub_epi32(w, _mm_slli_si128(w, 4));
    w = _mm_packs_epi32(w, w);
    return {whole - 1, _mm_cvtsi128_si32(_mm_packs_epi16(w, w))};
}

// What every pixel of a line is made of: the first of four others, and their weights.
struct Line {
    int count;
    int32_t first[kMostAcross], weights[kMostAcross];
};

// Makes a line of pixels. The four that each is made of are `apart` bytes apart; the first one is first[x]
// pixels behind `from`. If `weights` is not null, its eight are those of all pixels, and the first one lies
// x pixels behind `from`.
[[gnu::noinline]] void mix(const Line &line, const uint8_t *from, ptrdiff_t apart, const Int8 *weights,
                           uint8_t *out) {
    const __m256i forBytes =
        _mm256_broadcastsi128_si256(_mm_set_epi64x(0x0504050405040504, 0x0100010001000100));
    for (int next = 0; next < line.count; next += 8) {
        // The last eight may overlap those before them
        int x = min(next, line.count - 8), first = x;
        Int8 which = kLanes, w;
        if (weights)
            w = *weights;
        else {
            // A line is never shorter than what it is made of: eight pixels contain the firsts of eight
            first = line.first[x];
            which = loadInts(line.first + x) - first;
            w = loadInts(line.weights + x);
        }
        const uint8_t *at = from + first * 4;
        auto tap = [&] {
            __m256i v = _mm256_permutevar8x32_epi32(_mm256_loadu_si256((const __m256i *)at), (__m256i)which);
            at += apart;
            return v;
        };
        __m256i a = tap(), b = tap(), c = tap(), d = tap();
        // Sums of products, for the first two pixels of each four, then for the others
        auto half = [&](__m256i ab, __m256i cd, Int8 w) {
            auto products = [&](__m256i v, Int8 w) {
                return _mm256_maddubs_epi16(v, _mm256_shuffle_epi8((__m256i)w, forBytes));
            };
            __m256i sum = _mm256_add_epi16(products(ab, w), products(cd, w >> 16));
            return _mm256_srai_epi16(_mm256_add_epi16(sum, _mm256_set1_epi16(32)), 6);
        };
        __m256i mixed = _mm256_packus_epi16(half(_mm256_unpacklo_epi8(a, b), _mm256_unpacklo_epi8(c, d), w),
                                            half(_mm256_unpackhi_epi8(a, b), _mm256_unpackhi_epi8(c, d),
                                                 (Int8)_mm256_srli_si256((__m256i)w, 8)));
        mixed = _mm256_max_epu8(mixed, _mm256_min_epu8(b, c));
        mixed = _mm256_min_epu8(mixed, _mm256_max_epu8(b, c));
        _mm256_storeu_si256((__m256i *)(out + x * 4), mixed);
    }
}

} // namespace

void enlarge(const uint8_t *from, int width, int height, uint8_t *to, int toWidth, int toHeight,
             Workers &workers) {
    struct {
        const uint8_t *from;
        uint8_t *to;
        int width, height;
        float down;
        Line row;
    } t = {from, to, width, height, (float)height / (float)toHeight, {}};
    t.row.count = toWidth;
    for (int x = 0; x < toWidth; ++x) {
        Taps taps = tapsAt(x, (float)width / (float)toWidth, width);
        t.row.first[x] = taps.first, t.row.weights[x] = taps.weights;
    }
    parallelRanges(workers, toHeight, kBand, [&t](int begin, int end, int) {
        // The rows that these are made of, as wide as they will be
        uint8_t wide[kBand + 4][kMostAcross * 4];
        int top = tapsAt(begin, t.down, t.height).first, bottom = tapsAt(end - 1, t.down, t.height).first + 3;
        for (int y = top; y <= bottom; ++y)
            mix(t.row, t.from + (ptrdiff_t)y * t.width * 4, 4, nullptr, wide[y - top]);
        for (int y = begin; y < end; ++y) {
            Taps taps = tapsAt(y, t.down, t.height);
            Int8 weights = broadcast(taps.weights);
            mix(t.row, wide[taps.first - top], sizeof *wide, &weights, t.to + (ptrdiff_t)y * t.row.count * 4);
        }
    });
}

} // namespace odraz
