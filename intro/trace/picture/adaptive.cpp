#include "trace/picture/adaptive.h"

#include "trace/picture/criterion.h"
#include "trace/picture/fill.h"

namespace odraz {

namespace {

// Corners are averaged, which blurs on its own: what they see of textures in mirrors is filtered for half a
// pixel only. By PSNR 1 is 0.9 dB worse; less shimmers.
constexpr float kFilter = 0.5f;

ODRAZ_INLINE void want(TileScratch &s, uint32_t place) {
    s.wanted[s.wantedCount] = place;
    s.wantedCount += s.traced[place] != s.stamp;
    s.traced[place] = s.stamp;
}
void wantCorners(TileScratch &s, Square q, int size) {
    for (int k = 0; k < 4; ++k) want(s, placeAt(q.x + (k & 1) * size, q.y + (k >> 1) * size));
}
// The corners of a square's quarters, `half` wide, that are not its own.
ODRAZ_INLINE void wantMiddles(TileScratch &s, Square q, int half) {
    uint32_t across = (uint32_t)half, down = across << kPlaceShift,
             middle = placeAt(q.x, q.y) + across + down;
    want(s, middle - down), want(s, middle - across), want(s, middle), want(s, middle + across);
    want(s, middle + down);
}

// Appends a square's quarters, those that lie in the tile, and wants their corners. Returns how many these
// are; writes one more.
[[gnu::noinline]] int quarter(Tile &t, Square a, int half, Square *to) {
    bool right = a.x + half < 4 * t.width, below = a.y + half < 4 * t.height;
    uint8_t x = (uint8_t)(a.x + half), y = (uint8_t)(a.y + half);
    int count = 1;
    to[0] = a;
    to[count] = {x, a.y}, count += right;
    to[count] = {a.x, y}, count += below;
    to[count] = {x, y}, count += right & below;
    wantMiddles(t.s, a, half);
    return count;
}

// Traces what is wanted: whole samples for the corners of pixels; radiance for places between, as samples of
// a size below 1.
void traceWanted(Tile &t, float size) {
    TileScratch &s = t.s;
    bool corners = size == 1;
    for (int first = 0; first < s.wantedCount; first += kChunk) {
        int count = min(s.wantedCount - first, kChunk);
        for (int i = 0; i < count; i += 8) {
            Int8 place = loadInts((const int32_t *)s.wanted + first + i);
            Int8 x = place & ((1 << kPlaceShift) - 1), y = place >> kPlaceShift;
            store(s.x + i, fmadd(toFloat(x), 0.25f, (float)t.x0));
            store(s.y + i, fmadd(toFloat(y), 0.25f, (float)t.y0));
            store((int32_t *)s.index + i, corners ? (y >> 2) * kCorners + (x >> 2) : y * kPlaces + x);
        }
        traceSamples(t.scene, t.view, t.quality, s.trace, s.among, size * kFilter, count, s.x, s.y, s.index,
                     corners ? Samples(s.corners) : Samples(s.fine));
        for (int i = 0; corners && i < count; ++i) {
            uint32_t at = s.index[i];
            s.shown[at] = intensityOf(t.scene, s.corners[at]);
            s.marks[at] = marksOf(s.corners[at]);
        }
    }
    s.sampleCount += s.wantedCount;
    s.wantedCount = 0;
}

// Splits the first `count` squares level by level, down to a pixel at least; fills the rest. Returns how many
// pixels are left in squares[2], to be split on.
int splitSquares(Tile &t, int count) {
    TileScratch &s = t.s;
    const Quality &q = t.quality;
    Square *squares = s.squares[0], *next = s.squares[1];
    int rough = 0;
    for (int size = q.coarse; count; size /= 2) {
        int splits = 0, half = size / 2, left = 0;
        for (int i = 0; i < count; ++i) {
            Square a = squares[i];
            uint32_t c[4];
            cornersOf(a, size, c);
            if (size > 4) {
                if (size > q.fine && splitsSquare(t, a, size, c))
                    splits += quarter(t, a, half, next + splits);
                else
                    squares[left++] = a;
                continue;
            }
            if (q.fine < 4 && splitsPixel(t, a, c))
                s.squares[2][rough++] = a;
            else
                squares[left++] = a;
        }
        // What neighbours have found out splits more; all are asked before one splits, which wants new
        // corners
        for (int before = 0; size > 4 && splits > before;) {
            before = splits;
            traceWanted(t, 1);
            Square *more = s.squares[2];
            int kept = 0, found = 0;
            for (int i = 0; i < left; ++i)
                if (size > q.fine && splitsBySides(s, squares[i], size, q.mild))
                    more[found++] = squares[i];
                else
                    squares[kept++] = squares[i];
            left = kept;
            for (int i = 0; i < found; ++i) splits += quarter(t, more[i], half, next + splits);
        }
        for (int i = 0; i < left; ++i) fill(t, squares[i], size);
        Square *done = squares;
        squares = next;
        next = done;
        count = splits;
    }
    return rough;
}

// Splits pixels into halves, and these into quarters; every one left adds the mean of its corners.
void splitPixels(Tile &t, int count) {
    TileScratch &s = t.s;
    const Quality &q = t.quality;
    Square *squares = s.squares[2], *next = s.squares[0];
    for (int i = 0; i < count; ++i) {
        int p = (squares[i].y >> 2) * kTile + (squares[i].x >> 2);
        for (int k = 0; k < 3; ++k) s.rest[k][p] = 0;
        s.owner[p] = kMixed;
        keepRadiance(s, squares[i]);
    }
    float edge = q.edge * 2;
    for (int size = 4; count; size /= 2, edge *= 2) {
        int half = size / 2, splits = 0;
        for (int i = 0; i < count; ++i) wantMiddles(s, squares[i], half);
        traceWanted(t, (float)size * 0.125f);
        float weight = (float)(half * half) * (1.f / 64);
        for (int i = 0; i < count; ++i) {
            int p = (squares[i].y >> 2) * kTile + (squares[i].x >> 2);
            __m128 sum = {s.rest[0][p], s.rest[1][p], s.rest[2][p], 0};
            for (int k = 0; k < 4; ++k) {
                Square a = {(uint8_t)(squares[i].x + half * (k & 1)),
                            (uint8_t)(squares[i].y + half * (k >> 1))};
                if (half > q.fine && splitsPart(t, a, half, edge)) {
                    next[splits++] = a;
                    continue;
                }
                __m128 v[4];
                radianceAt(s, a, half, v);
                sum += (v[0] + v[1] + v[2] + v[3]) * weight;
            }
            for (int k = 0; k < 3; ++k) s.rest[k][p] = sum[k];
        }
        Square *done = squares;
        squares = next;
        next = done;
        count = splits;
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
    s.wantedCount = 0;
    watch(t);
    Square *squares = s.squares[0];
    int count = 0;
    for (int y = 0; y < 4 * t.height; y += q.coarse)
        for (int x = 0; x < 4 * t.width; x += q.coarse) {
            squares[count] = {(uint8_t)x, (uint8_t)y};
            wantCorners(s, squares[count++], q.coarse);
        }
    traceWanted(t, 1);
    splitPixels(t, splitSquares(t, count));
    finishTile(t);
}

} // namespace odraz
