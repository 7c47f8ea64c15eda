// Decides which squares and pixels of the quadtree split. All such decisions are here.
//
// As in the intro thesis, the corners of a square are compared by (a) the object hit, (b) the state of every
// light, (c) the hits of secondary rays and the texture cells there, (d) the intensities. (a) to (c) are
// marks, which every Sample has. Only (d) decides whether a pixel gets samples inside, at a lower threshold
// where (a) differs. Squares and pixels also split where there may be a shape that no corner shows
// (hidden.h), and squares where a sample on one of their sides, traced for a neighbour, differs. The Quality
// has the thresholds. A new criterion belongs in splitsSquare() and splitsPixel(), a new mark in marksOf().
// Where a square splits, meanSuffices() decides which of the new corners need not be traced.
#pragma once

#include "trace/picture/hidden.h"

namespace odraz {

// Radiance on a scale on which equal steps look about equally large.
ODRAZ_INLINE __m128 perceived(const Scene &scene, __m128 radiance) {
    __m128 v = radiance * scene.exposure;
    return _mm_sqrt_ps(v / (v + 0.7f));
}

// The difference between the greatest and the least of four (or two) colours, channel by channel.
ODRAZ_INLINE __m128 range(__m128 a, __m128 b, __m128 c, __m128 d) {
    return _mm_max_ps(_mm_max_ps(a, b), _mm_max_ps(c, d)) - _mm_min_ps(_mm_min_ps(a, b), _mm_min_ps(c, d));
}
ODRAZ_INLINE __m128 range(__m128 a, __m128 b) { return _mm_max_ps(a, b) - _mm_min_ps(a, b); }
ODRAZ_INLINE bool exceeds(__m128 difference, float threshold) {
    return _mm_movemask_ps(_mm_cmpgt_ps(difference, _mm_set1_ps(threshold)));
}
ODRAZ_INLINE __m128 rangeOf(const TileScratch &s, const uint32_t *c) {
    return range(s.perceived[c[0]], s.perceived[c[1]], s.perceived[c[2]], s.perceived[c[3]]);
}
// Whether the radiances at four corners, with textures, differ by more than a threshold.
[[gnu::noinline]] inline bool radianceExceeds(const Tile &t, const uint32_t *c, float threshold) {
    __m128 v[4];
    for (int k = 0; k < 4; ++k) v[k] = perceived(t.scene, radianceOf(t.s.corners[c[k]]));
    return exceeds(range(v[0], v[1], v[2], v[3]), threshold);
}

// The intensities by which a corner is compared, without its texture, which has a filter of its own.
ODRAZ_INLINE __m128 intensityOf(const Scene &scene, const Sample &c) {
    Rgb mean = c.id ? scene.mean[scene.shapes[c.shape()].material] : Rgb{};
    __m128 lit = fourOf(c.light) * __m128{mean.x, mean.y, mean.z, 0};
    return perceived(scene, lit + fourOf(c.rest));
}

// The marks of a corner: its shape, its lights, and the hits of its secondary rays. These are the thesis's
// tests (a) to (c). The fourth number, which is not compared, is set where a texture is mirrored.
ODRAZ_INLINE __m128i marksOf(const Sample &c) {
    return _mm_setr_epi32((int)c.id, (int)(c.lights & ~kTextured), (int)c.secondary,
                          (int)(c.lights & kTextured));
}

// The shape that all corners of a square show; -1: the sky, or several shapes.
ODRAZ_INLINE int shapeOf(const TileScratch &s, uint32_t corner, int same) {
    const Sample &c = s.corners[corner];
    return (same & kSameId) && c.id ? (int)c.shape() : -1;
}

// Why a square splits. Hidden: its corners are alike, but a shape may be hidden between them.
enum class Split { No, Differs, Hidden };

// Whether a square of more than a pixel splits, judged by its corners c. Squares of more than 2x2 pixels also
// split where a mirror or glass shows a texture, because corners do not show what lies between them.
ODRAZ_INLINE Split splitsSquare(const Tile &t, Square a, int size, const uint32_t *c) {
    const TileScratch &s = t.s;
    int same = alike(s, c);
    bool marks = same != kSameMarks;
    if (size > 2) {
        __m128i all = _mm_or_si128(_mm_or_si128(s.marks[c[0]], s.marks[c[1]]),
                                   _mm_or_si128(s.marks[c[2]], s.marks[c[3]]));
        bool textured = _mm_movemask_ps(_mm_castsi128_ps(all)) & 8,
             lamps = _mm_extract_epi32(all, 2) & kLamps;
        if (marks || textured || lamps) return Split::Differs;
    }
    __m128 difference = rangeOf(s, c);
    // Where shapes meet, also compare textures; in scenes with lines between patches, always split
    if (exceeds(difference, t.quality.threshold) || (marks && exceeds(difference, t.quality.markThreshold)) ||
        (!(same & kSameId) &&
         (t.scene.lines != 0 || radianceExceeds(t, c, min(t.quality.markThreshold, t.quality.outline)))))
        return Split::Differs;
    return mayHide(t, a, size, shapeOf(s, c[0], same)) ? Split::Hidden : Split::No;
}

// Whether the mean of corners a and b is good enough for the corner midway between them, `half` from both.
// Their marks must be equal. The larger `half` is, the less their brightness may differ: the error grows with
// the square of the distance. No mean is used in `film`, or near mirrored lamps.
ODRAZ_INLINE bool meanSuffices(const Tile &t, uint32_t a, uint32_t b, int half) {
    const TileScratch &s = t.s;
    return t.quality.smallest > 4 && alike(s, a, b) == kSameMarks && !(s.corners[a].secondary & kLamps) &&
           !exceeds(range(s.perceived[a], s.perceived[b]) * (float)(half * half),
                    3 * t.quality.markThreshold);
}

// Whether a sample on a side splits a square that its own corners, all alike, did not split. The sample was
// traced because a neighbour split, and it differs from the corners.
ODRAZ_INLINE bool splitsBySides(const TileScratch &s, Square a, int size, float markThreshold) {
    const uint32_t point = pointAt(a.x, a.y), corner = cornerAt(a.x, a.y);
    auto differs = [&](int x, int y) {
        if (s.traced[point + pointAt(x, y)] != s.stamp) return false;
        uint32_t other = corner + cornerAt(x, y);
        if (alike(s, other, corner) == kSameMarks) return false;
        return size > 2 || exceeds(range(s.perceived[corner], s.perceived[other]), markThreshold);
    };
    for (int k = 1; k < size; ++k)
        if (differs(k, 0) || differs(0, k) || differs(size, k) || differs(k, size)) return true;
    return false;
}

// Whether a pixel splits: by intensities and hidden shapes alone. A texture has a filter of its own.
ODRAZ_INLINE bool splitsPixel(const Tile &t, Square a, const uint32_t *c) {
    const TileScratch &s = t.s;
    int same = alike(s, c);
    int shape = shapeOf(s, c[0], same);
    bool calm = shape >= 0 && !exceeds(rangeOf(s, c), t.quality.edge);
    return (!calm && radianceExceeds(t, c, same & kSameId ? t.quality.edge : t.quality.outline)) ||
           mayHide(t, a, 1, shape);
}

} // namespace odraz
