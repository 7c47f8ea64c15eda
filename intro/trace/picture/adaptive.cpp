#include "trace/picture/adaptive.h"

#include "trace/picture/criterion.h"
#include "trace/picture/fill.h"

namespace odraz {

namespace {

// Width of a sample, in pixels, by which textures are filtered. Pixels are means of their corners, which
// blurs them, so half a pixel is best in mirrors. With a whole pixel, PSNR is 0.9 dB worse; with less than
// half, textures shimmer. But lines between patches are narrow: with half a pixel they would be dashed where
// surfaces meet.
float filterOf(const Scene &scene) { return scene.lines != 0 ? 1 : 0.5f; }

ODRAZ_INLINE void request(TileScratch &s, uint32_t point) {
    s.requested[s.requestedCount] = point;
    s.requestedCount += s.traced[point] != s.stamp;
    s.traced[point] = s.stamp;
}
void requestCorners(TileScratch &s, Square q, int size) {
    for (int k = 0; k < 4; ++k) request(s, pointAt(q.x + (k & 1) * size, q.y + (k >> 1) * size));
}
// Sets the corner midway between a and b to their mean, with the marks of a.
void average(TileScratch &s, uint32_t a, uint32_t b) {
    uint32_t middle = (a + b) / 2;
    const float *first = &s.corners[a].albedo.x, *second = &s.corners[b].albedo.x;
    float *to = &s.corners[middle].albedo.x;
    for (size_t k = 0; k < sizeof(Sample) / sizeof(float); k += 4) {
        __m128 one = _mm_load_ps(first + k), none = _mm_setzero_ps(),
               sum = _mm_blend_ps(one, none, 8) + _mm_blend_ps(_mm_load_ps(second + k), none, 8);
        _mm_store_ps(to + k, _mm_blend_ps(sum * 0.5f, one, 8));
    }
    s.perceived[middle] = (s.perceived[a] + s.perceived[b]) * 0.5f;
    s.marks[middle] = s.marks[a];
}

// Makes the corner midway between corners a and b: their mean if that is allowed and good enough, else it is
// requested. A mean does not count as traced, so a neighbouring square may still have it traced.
void makeMiddle(Tile &t, uint32_t a, uint32_t b, uint32_t point, int half, bool mayBeMean) {
    TileScratch &s = t.s;
    if (mayBeMean && s.traced[point] != s.stamp && meanSuffices(t, a, b, half))
        average(s, a, b);
    else
        request(s, point);
}

// Makes the corners of a square's quarters, `half` wide, that are not corners of the square. A mean may miss
// something between its ends. Such a thing mostly raises the contrast elsewhere in the square, so means are
// allowed only where the square's contrast is low. This leaves no gaps in lines and outlines.
void makeMiddles(Tile &t, Square q, int half, Split why) {
    TileScratch &s = t.s;
    uint32_t c[4], across = (uint32_t)half, down = across << kPointShift,
                   middle = pointAt(q.x, q.y) + across + down;
    cornersOf(q, half * 2, c);
    bool calm = why == Split::Differs && !exceeds(rangeOf(s, c), 2.5f * t.quality.threshold);
    makeMiddle(t, c[0], c[1], middle - down, half, calm);
    makeMiddle(t, c[0], c[2], middle - across, half, calm);
    request(s, middle);
    makeMiddle(t, c[1], c[3], middle + across, half, calm);
    makeMiddle(t, c[2], c[3], middle + down, half, calm);
}

// Makes a square's quarters in the tile, and their corners. Returns the count; `to` needs room for one more.
[[gnu::noinline]] int quarter(Tile &t, Square a, int half, Split why, Square *to) {
    bool right = a.x + half < t.width, below = a.y + half < t.height;
    uint8_t x = (uint8_t)(a.x + half), y = (uint8_t)(a.y + half);
    int count = 1;
    to[0] = a;
    to[count] = {x, a.y}, count += right;
    to[count] = {a.x, y}, count += below;
    to[count] = {x, y}, count += right & below;
    makeMiddles(t, a, half, why);
    return count;
}

// Traces the points in s.requested.
void traceRequested(Tile &t) {
    TileScratch &s = t.s;
    for (int first = 0; first < s.requestedCount; first += kChunk) {
        int count = min(s.requestedCount - first, kChunk);
        for (int i = 0; i < count; i += 8) {
            Int8 point = loadInts((const int32_t *)s.requested + first + i);
            Int8 x = point & ((1 << kPointShift) - 1), y = point >> kPointShift;
            store(s.x + i, toFloat(x + t.x0));
            store(s.y + i, toFloat(y + t.y0));
            store((int32_t *)s.index + i, y * kCorners + x);
        }
        traceSamples(t.scene, t.view, t.quality, s.trace,
                     {s.candidates, filterOf(t.scene), count, s.x, s.y, s.index}, s.corners);
        for (int i = 0; i < count; ++i) {
            uint32_t at = s.index[i];
            s.perceived[at] = intensityOf(t.scene, s.corners[at]);
            s.marks[at] = marksOf(s.corners[at]);
        }
    }
    s.sampleCount += s.requestedCount;
    s.requestedCount = 0;
}

// Splits the `count` squares of width `size` in squares[0], level by level down to single pixels, and fills
// those that do not split. Returns the number of pixels in squares[2], which need samples inside.
int splitSquares(Tile &t, int count, int size) {
    TileScratch &s = t.s;
    Square *squares = s.squares[0], *next = s.squares[1];
    int rough = 0, first = kTile * kTile, last = first; // the part of s.unsplit in use
    for (const int coarse = size; count;) {
        for (; count; size /= 2) {
            int splits = 0;
            for (int i = 0; i < count; ++i) {
                Square a = squares[i];
                uint32_t c[4];
                cornersOf(a, size, c);
                Split why = size > 1 ? splitsSquare(t, a, size, c) : Split::No;
                if (why != Split::No)
                    splits += quarter(t, a, size / 2, why, next + splits);
                else if (size == 1 && splitsPixel(t, a, c))
                    s.squares[2][rough++] = a;
                else
                    s.unsplit[size > 1 ? last++ : --first] = {a, (uint16_t)size};
            }
            traceRequested(t);
            Square *done = squares;
            squares = next, next = done;
            count = splits;
        }
        // Split the largest squares that samples traced for their neighbours split. Test all before the first
        // split, since that requests samples
        int found = 0;
        for (size = coarse; size > 1 && !found; size /= 2) {
            int kept = kTile * kTile;
            for (int i = kept; i < last; ++i) {
                SizedSquare a = s.unsplit[i];
                if (a.size == size && splitsBySides(s, a.square, size, t.quality.markThreshold))
                    squares[found++] = a.square;
                else
                    s.unsplit[kept++] = a;
            }
            last = kept;
        }
        for (int i = 0; i < found; ++i) count += quarter(t, squares[i], size, Split::Differs, next + count);
        traceRequested(t);
        Square *done = squares;
        squares = next, next = done;
    }
    for (; first < last; ++first) fill(t, s.unsplit[first].square, s.unsplit[first].size);
    return rough;
}

// The number of samples that a pixel takes first; the weight of each corner with these, and with all samples.
constexpr int kFirst = 3;
constexpr float kCornerWeight = 0.078f, kCornerWeightAll = 0.038f;

// Takes samples inside pixels: kFirst in each, and the others where the quality allows them and the first
// differ. A pixel shows a weighted mean of these and its corners.
void sampleInside(Tile &t, int count) {
    TileScratch &s = t.s;
    const Quality &q = t.quality;
    Square *pixels = s.squares[2];
    const __m128 white = _mm_set1_ps(whiteOf(t.scene));
    for (int from = 0, to = kFirst; count; from = to, to = kMostInside) {
        int perPixel = to - from, most = kChunk / perPixel, kept = 0;
        bool again = !from && q.smallest < 8;
        float cornerWeight = from ? kCornerWeightAll : kCornerWeight,
              insideWeight = (1 - 4 * cornerWeight) / (float)to;
        for (int first = 0; first < count; first += most) {
            int batch = min(count - first, most), samples = 0;
            for (int i = first; i < first + batch; ++i)
                for (int k = from; k < to; ++k) {
                    s.x[samples] = (float)(t.x0 + pixels[i].x) + 0.5f + kInsideX[k];
                    s.y[samples] = (float)(t.y0 + pixels[i].y) + 0.5f + kInsideY[k];
                    s.index[samples] = (uint32_t)samples;
                    ++samples;
                }
            traceSamples(t.scene, t.view, q, s.trace,
                         {s.candidates, filterOf(t.scene) / sqrt((float)to), samples, s.x, s.y, s.index},
                         s.inside);
            s.sampleCount += samples;
            const __m128 *v = s.inside;
            for (int i = first; i < first + batch; ++i) {
                Square a = pixels[i];
                int p = a.y * kTile + a.x;
                uint32_t c[4];
                cornersOf(a, 1, c);
                __m128 corners = {}, inside = {}, hi = {}, lo = _mm_set1_ps(kInfinity), darkest = lo;
                auto add = [&](__m128 &sum, __m128 radiance) {
                    sum += _mm_min_ps(radiance, white);
                    darkest = _mm_min_ps(darkest, radiance);
                    if (!again) return;
                    __m128 seen = perceived(t.scene, radiance);
                    lo = _mm_min_ps(lo, seen), hi = _mm_max_ps(hi, seen);
                };
                for (uint32_t k : c) add(corners, radianceOf(s.corners[k]));
                if (from) inside = __m128{s.light[0][p], s.light[1][p], s.light[2][p], 0};
                for (int k = from; k < to; ++k, ++v) add(inside, *v);
                if (again && exceeds(hi - lo, q.again)) pixels[kept++] = a;
                __m128 sum = _mm_max_ps(corners * cornerWeight + inside * insideWeight, darkest);
                for (int k = 0; k < 3; ++k) s.light[k][p] = inside[k], s.rest[k][p] = sum[k];
                s.shape[p] = kMixed;
            }
        }
        count = kept;
    }
}

} // namespace

void traceAdaptive(Tile &t) {
    TileScratch &s = t.s;
    const Quality &q = t.quality;
    if (++s.stamp == 0) {
        for (uint8_t &traced : s.traced) traced = 0;
        s.stamp = 1;
    }
    s.requestedCount = 0;
    findBallsAndThinShapes(t);
    Square *squares = s.squares[0];
    int count = 0;
    const int size = q.coarse >> 2;
    for (int y = 0; y < t.height; y += size)
        for (int x = 0; x < t.width; x += size) {
            squares[count] = {(uint8_t)x, (uint8_t)y};
            requestCorners(s, squares[count++], size);
        }
    traceRequested(t);
    sampleInside(t, splitSquares(t, count, size));
    finishTile(t);
}

} // namespace odraz
