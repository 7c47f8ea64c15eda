#include "trace/picture/adaptive.h"

#include "trace/picture/criterion.h"
#include "trace/picture/fill.h"

namespace odraz {

namespace {

// Corners are averaged, which blurs on its own: what they see of textures in mirrors is filtered for half a
// pixel only. By PSNR 1 is 0.9 dB worse; less shimmers.
constexpr float kFilter = 0.5f;

void want(TileScratch &s, int x, int y) {
    uint32_t i = placeAt(x, y);
    if (s.traced[i] == s.stamp) return;
    s.traced[i] = s.stamp;
    s.wanted[s.wantedCount++] = i;
}
void wantCorners(TileScratch &s, Square q, int size) {
    for (int k = 0; k < 4; ++k) want(s, q.x + (k & 1) * size, q.y + (k >> 1) * size);
}
// The corners of a square's quarters that are not its own.
void wantMiddles(TileScratch &s, Square q, int size) {
    int half = size / 2;
    want(s, q.x + half, q.y);
    want(s, q.x, q.y + half);
    want(s, q.x + half, q.y + half);
    want(s, q.x + size, q.y + half);
    want(s, q.x + half, q.y + size);
}

// Traces what is wanted: whole samples for the corners of pixels; radiance for places between, as samples of
// a size below 1.
void traceWanted(Tile &t, float size) {
    TileScratch &s = t.s;
    float *x = s.x, *y = s.y;
    uint32_t *index = s.index;
    bool corners = size == 1;
    for (int first = 0; first < s.wantedCount; first += kChunk) {
        int count = min(s.wantedCount - first, kChunk);
        for (int i = 0; i < count; ++i) {
            int px = (int)s.wanted[first + i] % kPlaces, py = (int)s.wanted[first + i] / kPlaces;
            x[i] = (float)t.x0 + (float)px * 0.25f;
            y[i] = (float)t.y0 + (float)py * 0.25f;
            index[i] = corners ? cornerAt(px, py) : (uint32_t)i;
        }
        traceSamples(t.scene, t.view, t.quality, s.trace, s.among, size * kFilter, count, x, y, index,
                     corners ? s.corners : s.samples);
        for (int i = 0; i < count; ++i)
            if (corners)
                s.shown[index[i]] = intensityOf(t.scene, s.corners[index[i]]);
            else
                s.fine[s.wanted[first + i]] = radianceOf(s.samples[i]);
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
        auto split = [&](Square a) {
            for (int k = 0; k < 4; ++k) {
                Square child = {(uint8_t)(a.x + half * (k & 1)), (uint8_t)(a.y + half * (k >> 1))};
                if (child.x < 4 * t.width && child.y < 4 * t.height) next[splits++] = child;
            }
            wantMiddles(s, a, size);
        };
        for (int i = 0; i < count; ++i) {
            Square a = squares[i];
            uint32_t c[4];
            cornersOf(a, size, c);
            int shape = onSilhouette(s, c) || !s.corners[c[0]].id ? -1 : (int)s.corners[c[0]].shape();
            if (size > 4) {
                if (size > q.fine && splitsSquare(t, a, size, c, shape))
                    split(a);
                else
                    squares[left++] = a;
                continue;
            }
            if (q.fine < 4 && splitsPixel(t, a, c, shape))
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
            for (int i = 0; i < found; ++i) split(more[i]);
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
    }
    float edge = q.edge * 2;
    for (int size = 4; count; size /= 2, edge *= 2) {
        for (int i = 0; i < count; ++i) wantMiddles(s, squares[i], size);
        traceWanted(t, (float)size * 0.125f);
        int half = size / 2, splits = 0;
        float weight = (float)(half * half) * (1.f / 64);
        for (int i = 0; i < 4 * count; ++i) {
            Square a = squares[i >> 2];
            a = {(uint8_t)(a.x + half * (i & 1)), (uint8_t)(a.y + half * (i >> 1 & 1))};
            __m128 v[4];
            radianceAt(s, a, half, v);
            if (half > q.fine && splitsPart(t, a, half, v, edge)) {
                next[splits++] = a;
                continue;
            }
            __m128 sum = (v[0] + v[1] + v[2] + v[3]) * weight;
            int p = (a.y >> 2) * kTile + (a.x >> 2);
            for (int k = 0; k < 3; ++k) s.rest[k][p] += sum[k];
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
