// A tile of the frame while it is being traced: its corners and squares, and the pixels that they fill.
//
// Squares have whole pixels as sides, and a Sample at each corner. Neighbouring tiles share their outer
// corners; each tile traces them again.
#pragma once

#include "trace/picture/frame.h"
#include "trace/shade/whitted.h"

namespace odraz {

inline constexpr int kTile = 64;                       // pixels along a side
inline constexpr int kCorners = kTile + 1;             // corners of pixels along a side
inline constexpr int kPointShift = 7;                  // a row of points is 2^7 long, see pointAt()
inline constexpr int kDiscs = 1024, kThinShapes = 192; // limits on the balls and thin shapes of a tile
// TileScratch::shape of pixels without an albedo. kMixed: several shapes or samples. kSky: sky. kDone:
// already in the frame.
inline constexpr uint16_t kMixed = kManyShapes, kSky = kSkyShown, kDone = 0xfffd;
static_assert(kMaxShapes <= kDone);

// A square of the tile, by its upper left corner.
struct Square {
    uint8_t x, y;
};
struct SizedSquare {
    Square square;
    uint16_t size; // pixels
};

// Balls as seen in the picture: ellipses whose long axes point to its centre. Structure of arrays.
struct Discs {
    int count;
    float x[kDiscs + 8], y[kDiscs + 8];             // centre, pixels
    float alongX[kDiscs + 8], alongY[kDiscs + 8];   // unit vector along the long axis / half its length
    float acrossX[kDiscs + 8], acrossY[kDiscs + 8]; // the same for the short axis
    float perHalf[kDiscs + 8];                      // 1 / half the short axis
    float near[kDiscs + 8];                         // world distance of the nearest point
    int32_t shape[kDiscs + 8];
};

// Long and thin shapes that the corners may miss: all points within `radius` of a line, in pixels.
struct ThinShapes {
    int count;
    float x[kThinShapes + 8], y[kThinShapes + 8];           // one end
    float alongX[kThinShapes + 8], alongY[kThinShapes + 8]; // from that end to the other
    float radius[kThinShapes + 8];
};

struct TileScratch {
    int64_t sampleCount;
    int requestedCount;
    uint8_t stamp;
    Candidates candidates; // the shapes that the tile's primary rays may hit
    Sample corners[kCorners * kCorners];
    __m128 perceived[kCorners * kCorners];       // perceived intensities at corners, without the texture
    __m128i marks[kCorners * kCorners];          // marks of corners: id, lights, secondary; then kTextured
    __m128 inside[kChunk];                       // radiance of samples within pixels
    uint8_t traced[kCorners << kPointShift];     // equal to `stamp` where a corner is traced or requested
    uint32_t requested[kCorners * kCorners + 8]; // points to trace next, with room for one more
    // Points that are being traced, in pixels of the picture, and the indices of their samples. They are read
    // eight at a time, so stale values after the last one are read, too
    float x[kChunk], y[kChunk];
    uint32_t index[kChunk];
    Square squares[3][kTile * kTile + 4];
    // Squares to fill: pixels in the first half, from its end; larger ones, which may still split, in the
    // second
    SizedSquare unsplit[2 * kTile * kTile];
    // The filled tile, pixel by pixel: interpolated light and rest; the shape whose albedo multiplies light
    float light[3][kTile * kTile + 8], rest[3][kTile * kTile + 8];
    uint16_t shape[kTile * kTile + 8];
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
    int x0, y0, width, height; // the part of the frame that the tile covers, in pixels
};

// pointAt() packs a point of the tile into a number with bits for x and y; cornerAt() is its corner's index.
ODRAZ_INLINE uint32_t pointAt(int x, int y) { return (uint32_t)(y << kPointShift | x); }
ODRAZ_INLINE uint32_t cornerAt(int x, int y) { return (uint32_t)(y * kCorners + x); }

// Indices of a square's corners: upper left, upper right, lower left, lower right.
ODRAZ_INLINE void cornersOf(Square q, int size, uint32_t *c) {
    c[0] = cornerAt(q.x, q.y);
    c[1] = c[0] + (uint32_t)size;
    c[2] = c[0] + (uint32_t)size * kCorners;
    c[3] = c[2] + (uint32_t)size;
}

// Samples are clamped to this radiance before they are averaged, unless the whole pixel is brighter.
// Otherwise one sample of a lamp makes a pixel white, and edges of lamps alias. (Above this radiance the tone
// curve rises little.) Of the limits 0.7, 1, 1.5 and 2.5, times exposure, 1 comes closest to pictures with
// four times as many pixels a side that were scaled down after the tone curve.
inline float whiteOf(const Scene &scene) { return 1 / scene.exposure; }

// Positions of samples in a pixel, from its centre. A search found them, together with the weights of the
// corners (adaptive.cpp), as the best estimate of how much of a pixel lies beyond an edge that crosses it.
// Edges along the axes counted most, as their stairs are longest. The rms error of the first three is 0.074.
// A grid of three by three (corners, middles of sides, and the centre) takes one more sample; its error is
// 0.096. The error of all twelve is 0.033; the error of a grid of five by five is 0.038.
inline constexpr int kMostInside = 12;
inline constexpr float kInsideX[kMostInside] = {-0.043f, 0.242f, -0.215f, 0.365f, 0.37f,   -0.124f,
                                                -0.383f, 0.099f, -0.143f, 0.023f, -0.316f, 0.149f},
                       kInsideY[kMostInside] = {-0.236f, -0.006f, 0.224f,  -0.226f, 0.158f,  0.401f,
                                                0.006f,  -0.386f, -0.082f, 0.133f,  -0.323f, 0.314f};

// Returns a bit for each mark that two (or four) corners share: kSameId for the shape, kSameMarks for all.
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
