#include "trace/picture/adaptive.h"

#include "trace/picture/tile.h"

namespace odraz {

namespace {

// Corners are averaged, which blurs on its own: what they see of textures in mirrors is filtered for half a
// pixel only. By PSNR 1 is 0.9 dB worse; less shimmers.
constexpr float kFilter = 0.5f;

void want(TileScratch &s, int x, int y) {
    uint32_t i = (uint32_t)(y * kPlaces + x);
    if (s.traced[i] == s.stamp) return;
    s.traced[i] = s.stamp;
    s.wanted[s.wantedCount++] = i;
}
void wantCorners(TileScratch &s, Square q, int size) {
    want(s, q.x, q.y), want(s, q.x + size, q.y), want(s, q.x, q.y + size), want(s, q.x + size, q.y + size);
}
// The corners of a square's quarters that are not its own.
void wantMiddles(TileScratch &s, Square q, int size) {
    int half = size / 2;
    want(s, q.x + half, q.y), want(s, q.x, q.y + half), want(s, q.x + half, q.y + half);
    want(s, q.x + size, q.y + half), want(s, q.x + half, q.y + size);
}

// Traces what is wanted: whole samples for the corners of pixels; radiance for places between, as samples of
// a size below 1.
void traceWanted(Tile &t, float size) {
    TileScratch &s = t.s;
    float x[kChunk], y[kChunk];
    uint32_t index[kChunk];
    bool corners = size == 1;
    for (int first = 0; first < s.wantedCount; first += kChunk) {
        int count = min(s.wantedCount - first, kChunk);
        for (int i = 0; i < count; ++i) {
            int px = (int)s.wanted[first + i] % kPlaces, py = (int)s.wanted[first + i] / kPlaces;
            x[i] = (float)t.x0 + (float)px * 0.25f;
            y[i] = (float)t.y0 + (float)py * 0.25f;
            index[i] = (uint32_t)(corners ? (py >> 2) * kCorners + (px >> 2) : i);
        }
        traceSamples(t.scene, t.view, t.quality, s.trace, s.among, size * kFilter, count, x, y, index,
                     corners ? s.corners : s.samples);
        for (int i = 0; i < count; ++i) {
            if (!corners) {
                s.fine[s.wanted[first + i]] = radianceOf(s.samples[i]);
                continue;
            }
            const Sample &c = s.corners[index[i]];
            Rgb mean = c.id ? t.scene.mean[t.scene.shapes[c.shape()].material] : Rgb{};
            __m128 lit = fourOf(c.light) * __m128{mean.x, mean.y, mean.z, 0};
            s.shown[index[i]] = shown(t.scene, lit + fourOf(c.rest));
        }
    }
    s.sampleCount += s.wantedCount;
    s.wantedCount = 0;
}

float rangeOf(const TileScratch &s, const int *c) {
    return range({s.shown[c[0]], s.shown[c[1]], s.shown[c[2]], s.shown[c[3]]});
}

// Whether two samples show the same thing, lit and mirroring alike: the first three of the thesis's four
// tests.
bool sameMarks(const Sample &a, const Sample &b) {
    return a.id == b.id && !((a.lights ^ b.lights) & ~kTextured) && a.secondary == b.secondary;
}

// The four tests of a square's corners, in the thesis's order. Where a mirror or glass shows a texture, the
// corners of a larger square cannot tell what lies between.
bool differ(const TileScratch &s, const int *c, int size, const Quality &q) {
    const Sample *k[4] = {&s.corners[c[0]], &s.corners[c[1]], &s.corners[c[2]], &s.corners[c[3]]};
    bool marks = !(sameMarks(*k[0], *k[1]) && sameMarks(*k[0], *k[2]) && sameMarks(*k[0], *k[3]));
    bool textured = (k[0]->lights | k[1]->lights | k[2]->lights | k[3]->lights) & kTextured;
    if ((marks || textured) && size > 8) return true;
    float difference = rangeOf(s, c);
    return difference > q.threshold || (marks && difference > q.mild);
}

// Whether a sample in the middle of one of a square's sides, traced because a neighbour split, differs from
// the corners, all alike, that let the square be.
bool sidesDiffer(const TileScratch &s, Square a, int size, float mild) {
    const int half = size / 2, x[4] = {a.x + half, a.x, a.x + size, a.x + half},
              y[4] = {a.y, a.y + half, a.y + half, a.y + size};
    int corner = (a.y >> 2) * kCorners + (a.x >> 2);
    const Sample &c = s.corners[corner];
    for (int i = 0; i < 4; ++i) {
        if (s.traced[y[i] * kPlaces + x[i]] != s.stamp) continue;
        int middle = (y[i] >> 2) * kCorners + (x[i] >> 2);
        if (sameMarks(s.corners[middle], c)) continue;
        if (size > 8 || range({s.shown[corner], s.shown[middle], s.shown[corner], s.shown[middle]}) > mild)
            return true;
    }
    return false;
}

// Radiance at the corners of a square below a pixel.
__m128 radianceAt(const TileScratch &s, int x, int y) {
    if ((x | y) & 3) return s.fine[y * kPlaces + x];
    return radianceOf(s.corners[(y >> 2) * kCorners + (x >> 2)]);
}
void radianceOf(const TileScratch &s, Square q, int size, __m128 (&v)[4]) {
    for (int i = 0; i < 4; ++i) v[i] = radianceAt(s, q.x + (i & 1) * size, q.y + (i >> 1) * size);
}
float rangeOf(const Tile &t, const __m128 (&v)[4]) {
    return range({shown(t.scene, v[0]), shown(t.scene, v[1]), shown(t.scene, v[2]), shown(t.scene, v[3])});
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
            int c[4];
            cornersOf(a, size, c);
            int shape = onSilhouette(s, c) || !s.corners[c[0]].id ? -1 : (int)s.corners[c[0]].shape();
            if (size > 4) {
                if (size > q.fine && (differ(s, c, size, q) || mayHide(t, a, size, shape)))
                    split(a);
                else
                    squares[left++] = a;
                continue;
            }
            // Below a pixel only what is seen decides; where nothing but the texture differs its own filter
            // serves
            bool isRough = false;
            if (q.fine < 4) {
                bool calm = shape >= 0 && rangeOf(s, c) <= q.edge;
                if (!calm) {
                    __m128 v[4];
                    radianceOf(s, a, size, v);
                    isRough = rangeOf(t, v) > q.edge;
                }
                isRough |= !isRough && mayHide(t, a, size, shape);
            }
            if (isRough)
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
                if (size > q.fine && sidesDiffer(s, squares[i], size, q.mild))
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
            radianceOf(s, a, half, v);
            if (half > q.fine && (rangeOf(t, v) > edge || mayHide(t, a, half, -1))) {
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
