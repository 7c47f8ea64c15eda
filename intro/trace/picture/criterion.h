// What splits a square of the quadtree: the one place where that is decided.
//
// After the intro thesis, the corners of a square are compared by (a) the object hit, (b) the state of any
// light there, (c) what secondary rays hit, level by level, and the cell of a texture there, (d) the
// intensities. (a) to (c) are marks, kept in every Sample; below a pixel (d) alone decides. Beyond it a
// square splits where a shape may show in it that shows at no corner (hidden.h), and where a corner that a
// neighbour traced on its side tells of something new. Thresholds are the Quality's. A new criterion is asked
// in splitsSquare() and splitsPixel(); one of marks belongs in sameMarks().
#pragma once

#include "trace/picture/hidden.h"

namespace odraz {

// Radiance on a scale on which equal steps look about equally large.
ODRAZ_INLINE __m128 shown(const Scene &scene, __m128 radiance) {
    __m128 v = radiance * scene.exposure;
    return _mm_sqrt_ps(v / (v + 0.7f));
}

// The largest difference between four colours in one channel.
ODRAZ_INLINE float range(const __m128 (&v)[4]) {
    __m128 lo = _mm_min_ps(_mm_min_ps(v[0], v[1]), _mm_min_ps(v[2], v[3]));
    __m128 hi = _mm_max_ps(_mm_max_ps(v[0], v[1]), _mm_max_ps(v[2], v[3]));
    __m128 d = hi - lo;
    return max(d[0], max(d[1], d[2]));
}

// (Out of line: each is asked in several places of one large function.)
[[gnu::noinline]] inline float rangeOf(const TileScratch &s, const uint32_t *c) {
    return range({s.shown[c[0]], s.shown[c[1]], s.shown[c[2]], s.shown[c[3]]});
}
[[gnu::noinline]] inline float rangeOf(const Tile &t, const __m128 (&v)[4]) {
    return range({shown(t.scene, v[0]), shown(t.scene, v[1]), shown(t.scene, v[2]), shown(t.scene, v[3])});
}

// The intensities by which a corner is compared, its texture left out: where nothing else differs, that has a
// filter of its own.
ODRAZ_INLINE __m128 intensityOf(const Scene &scene, const Sample &c) {
    Rgb mean = c.id ? scene.mean[scene.shapes[c.shape()].material] : Rgb{};
    __m128 lit = fourOf(c.light) * __m128{mean.x, mean.y, mean.z, 0};
    return shown(scene, lit + fourOf(c.rest));
}

// Whether two samples show the same thing, lit and mirroring alike: the first three of the thesis's four
// tests.
inline bool sameMarks(const Sample &a, const Sample &b) {
    return a.id == b.id && !((a.lights ^ b.lights) & ~kTextured) && a.secondary == b.secondary;
}

// Whether a square of more than a pixel splits, by its corners c, which all show `shape` (-1: the sky, or not
// the same). Where a mirror or glass shows a texture, the corners of a larger square cannot tell what lies
// between.
inline bool splitsSquare(const Tile &t, Square a, int size, const uint32_t *c, int shape) {
    const TileScratch &s = t.s;
    const Sample *k[4] = {&s.corners[c[0]], &s.corners[c[1]], &s.corners[c[2]], &s.corners[c[3]]};
    bool marks = !(sameMarks(*k[0], *k[1]) && sameMarks(*k[0], *k[2]) && sameMarks(*k[0], *k[3]));
    bool textured = (k[0]->lights | k[1]->lights | k[2]->lights | k[3]->lights) & kTextured;
    if ((marks || textured) && size > 8) return true;
    float difference = rangeOf(s, c);
    return difference > t.quality.threshold || (marks && difference > t.quality.mild) ||
           mayHide(t, a, size, shape);
}

// Whether a sample in the middle of one of a square's sides, traced because a neighbour split, differs from
// the corners, all alike, that let the square be.
inline bool splitsBySides(const TileScratch &s, Square a, int size, float mild) {
    const int half = size / 2, x[4] = {a.x + half, a.x, a.x + size, a.x + half},
              y[4] = {a.y, a.y + half, a.y + half, a.y + size};
    uint32_t corner = cornerAt(a.x, a.y);
    const Sample &c = s.corners[corner];
    for (int i = 0; i < 4; ++i) {
        if (s.traced[placeAt(x[i], y[i])] != s.stamp) continue;
        uint32_t middle = cornerAt(x[i], y[i]);
        if (sameMarks(s.corners[middle], c)) continue;
        if (size > 8 || range({s.shown[corner], s.shown[middle], s.shown[corner], s.shown[middle]}) > mild)
            return true;
    }
    return false;
}

// Whether a pixel splits. Only what is seen decides; where nothing but the texture differs its own filter
// serves.
inline bool splitsPixel(const Tile &t, Square a, const uint32_t *c, int shape) {
    bool calm = shape >= 0 && rangeOf(t.s, c) <= t.quality.edge;
    if (!calm) {
        __m128 v[4];
        for (int i = 0; i < 4; ++i) v[i] = radianceOf(t.s.corners[c[i]]);
        if (rangeOf(t, v) > t.quality.edge) return true;
    }
    return mayHide(t, a, 4, shape);
}

// Whether a part of a pixel splits, by the radiance at its corners; `edge` is the quality's, doubled a level.
inline bool splitsPart(const Tile &t, Square a, int size, const __m128 (&v)[4], float edge) {
    return rangeOf(t, v) > edge || mayHide(t, a, size, -1);
}

} // namespace odraz
