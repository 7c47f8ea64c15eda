// A tile of the frame while it is being traced: its corners and squares, and the pixels that they fill.
//
// The sides of squares are whole pixels; their corners keep whole samples. Neighbouring tiles share their
// outer corners, and each tile traces them for itself.
#pragma once

#include "trace/picture/frame.h"
#include "trace/shade/whitted.h"

namespace odraz {

inline constexpr int kTile = 64;                       // pixels along a side
inline constexpr int kCorners = kTile + 1;             // of pixels, along a side
inline constexpr int kPlaceShift = 7;                  // a row of places is 2^7 long
inline constexpr int kDiscs = 1024, kThinShapes = 192; // most balls and thin shapes that a tile keeps
// Owners of pixels whose light is not multiplied by an albedo: several shapes or super-sampled; sky; done.
inline constexpr uint16_t kMixed = kManyShapes, kSky = kSkyShown, kDone = 0xfffd;
static_assert(kMaxShapes <= kDone);

// A square of the tile, by its upper left corner.
struct Square {
    uint8_t x, y;
};

// Balls as the picture shows them: ellipses that point to its middle. Structure of arrays, for eight at once.
struct Discs {
    int count;
    float x[kDiscs + 8], y[kDiscs + 8];             // middle, pixels
    float alongX[kDiscs + 8], alongY[kDiscs + 8];   // unit vector along one axis, over its half length
    float acrossX[kDiscs + 8], acrossY[kDiscs + 8]; // the same for the other axis
    float perHalf[kDiscs + 8];                      // 1 / the shorter half axis
    float near[kDiscs + 8];                         // world distance
    int32_t shape[kDiscs + 8];
};

// Long and thin shapes that may slip between the corners: all points within `radius` of a line, in pixels.
struct ThinShapes {
    int count, images;                                      // images: the first that is seen in a mirror
    float x[kThinShapes + 8], y[kThinShapes + 8];           // one end
    float alongX[kThinShapes + 8], alongY[kThinShapes + 8]; // the way to the other
    float radius[kThinShapes + 8];
};

struct TileScratch {
    int64_t sampleCount;
    int requestedCount;
    uint8_t stamp;
    Candidates among; // what the tile's primary rays may hit
    Sample corners[kCorners * kCorners];
    __m128 shown[kCorners * kCorners];  // intensities there as the eye weighs them, without the texture
    __m128i marks[kCorners * kCorners]; // by which they are compared: id, lights, secondary; then kTextured
    __m128 inside[kChunk];              // radiance of samples within pixels
    uint8_t traced[kCorners << kPlaceShift]; // equal to `stamp` where a corner is traced or requested
    // Places to trace next; one more may be written behind them
    uint32_t requested[kCorners * kCorners + 8];
    // Points that are being traced, in pixels of the picture, and the indices of their samples. They are read
    // eight at a time: behind the last one are old values
    float x[kChunk], y[kChunk];
    uint32_t index[kChunk];
    Square squares[3][kTile * kTile + 4];
    // The filled tile, pixel by pixel: interpolated light and rest, and the shape whose albedo multiplies the
    // light
    float light[3][kTile * kTile + 8], rest[3][kTile * kTile + 8];
    uint16_t owner[kTile * kTile + 8];
    Discs discs;
    ThinShapes thin;
    TraceScratch trace;
};

struct Tile {
    TileScratch &s;
    const Scene &scene;
    const View &view;
    const Quality &quality;
    Frame &frame;
    int x0, y0, width, height; // the part of the frame that it covers, in pixels
};

// The number of a place, counted from the tile's upper left corner, and the index of the corner there.
ODRAZ_INLINE uint32_t placeAt(int x, int y) { return (uint32_t)(y << kPlaceShift | x); }
ODRAZ_INLINE uint32_t cornerAt(int x, int y) { return (uint32_t)(y * kCorners + x); }

// Indices of a square's corners: upper left, upper right, lower left, lower right.
ODRAZ_INLINE void cornersOf(Square q, int size, uint32_t *c) {
    c[0] = cornerAt(q.x, q.y);
    c[1] = c[0] + (uint32_t)size;
    c[2] = c[0] + (uint32_t)size * kCorners;
    c[3] = c[2] + (uint32_t)size;
}

// The most that a sample brings to a pixel's mean, unless all of the pixel is brighter: the tone curve shows
// more of it as hardly brighter. Without this limit one sample of a lamp makes a whole pixel white, and edges
// of what glows get stairs and crumbs. Of the limits .7, 1, 1.5 and 2.5, in exposed light, 1 comes nearest to
// pictures of four times as many pixels a side, whose pixels were averaged as the screen shows them.
inline float whiteOf(const Scene &scene) { return 1 / scene.exposure; }

// The shape that a corner shows; -1: the sky.
ODRAZ_INLINE int shapeOrSky(const Sample &s) { return (int)(s.id + 7) / 8 - 1; }

// Where samples stand in a pixel, from its middle. A search found these places, together with the weights of
// the corners beside them (adaptive.cpp). They give the best estimate of how much of a pixel lies beyond an
// edge that crosses it. Edges along the axes counted most, as their stairs are longest. The first three are
// off by 0.074 (rms). A grid of three by three (corners, middles of sides, and the middle) costs one more and
// is off by 0.096. All twelve are off by 0.033; five by five places are off by 0.038.
inline constexpr int kMostInside = 12;
inline constexpr float kInsideX[kMostInside] = {-0.043f, 0.242f, -0.215f, 0.365f, 0.37f,   -0.124f,
                                                -0.383f, 0.099f, -0.143f, 0.023f, -0.316f, 0.149f},
                       kInsideY[kMostInside] = {-0.236f, -0.006f, 0.224f,  -0.226f, 0.158f,  0.401f,
                                                0.006f,  -0.386f, -0.082f, 0.133f,  -0.323f, 0.314f};

// Which marks two corners have in common, a bit for each: kSameId for the shape, kSameMarks for all.
inline constexpr int kSameId = 1, kSameMarks = 7;
ODRAZ_INLINE int alike(const TileScratch &s, uint32_t a, uint32_t b) {
    return _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpeq_epi32(s.marks[a], s.marks[b]))) & kSameMarks;
}
ODRAZ_INLINE int alike(const TileScratch &s, const uint32_t *c) {
    auto same = [&](int k) { return _mm_cmpeq_epi32(s.marks[c[0]], s.marks[c[k]]); };
    __m128i all = _mm_and_si128(same(1), _mm_and_si128(same(2), same(3)));
    return _mm_movemask_ps(_mm_castsi128_ps(all)) & kSameMarks;
}

} // namespace odraz
