// A tile of the frame while it is being traced: its corners and squares, and the pixels that they fill.
//
// Squares have whole pixels along their sides; their corners keep whole samples. A tile shares its outer
// corners with its neighbours, which trace them anew.
#pragma once

#include "trace/picture/frame.h"
#include "trace/shade/whitted.h"

namespace odraz {

inline constexpr int kTile = 64;                   // pixels along a side
inline constexpr int kCorners = kTile + 1;         // of pixels, along a side
inline constexpr int kPlaceShift = 7;              // rows of places are apart by a power of two
inline constexpr int kDiscs = 1024, kGrains = 192; // balls and thin shapes that a tile watches for at most
// Of pixels that no albedo is to be joined to: of several shapes or super-sampled, of the sky, done.
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
    float alongX[kDiscs + 8], alongY[kDiscs + 8];   // axis, unit, over its half length
    float acrossX[kDiscs + 8], acrossY[kDiscs + 8]; // the same over that of the other
    float perHalf[kDiscs + 8];                      // 1 / the shorter half axis
    float near[kDiscs + 8];                         // world distance
    int32_t shape[kDiscs + 8];
};

// A long and thin shape that may slip between the corners: all that lies within the radius of a line.
struct Grain {
    float x, y, alongX, alongY, radius; // one end, the way to the other, pixels
};

struct TileScratch {
    int64_t sampleCount;
    int wantedCount, grainCount;
    uint8_t stamp;
    Candidates among; // what the tile's primary rays may meet
    Grain grains[kGrains];
    Sample corners[kCorners * kCorners];
    __m128 shown[kCorners * kCorners];       // intensities there as the eye weighs them, texture left out
    __m128i marks[kCorners * kCorners];      // what tells one from another: id, lights, secondary; kTextured
    __m128 inside[kChunk];                   // radiance of samples within pixels
    uint8_t traced[kCorners << kPlaceShift]; // equal to `stamp` where a corner is
    // Places wanted next; room for one that is not
    uint32_t wanted[kCorners * kCorners + 8];
    // Places that are being traced, pixels of the picture, and the samples that they go to. Read by eight:
    // behind the last one stands what was there before
    float x[kChunk], y[kChunk];
    uint32_t index[kChunk];
    Square squares[3][kTile * kTile + 4];
    // The filled tile, pixel by pixel: interpolated light and rest, and whose albedo joins them
    float light[3][kTile * kTile + 8], rest[3][kTile * kTile + 8];
    uint16_t owner[kTile * kTile + 8];
    Discs discs;
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

// A place by one number, from the tile's upper left corner, and the index of the corner that stands there.
ODRAZ_INLINE uint32_t placeAt(int x, int y) { return (uint32_t)(y << kPlaceShift | x); }
ODRAZ_INLINE uint32_t cornerAt(int x, int y) { return (uint32_t)(y * kCorners + x); }

// Indices of a square's corners: upper left, upper right, lower left, lower right.
ODRAZ_INLINE void cornersOf(Square q, int size, uint32_t *c) {
    c[0] = cornerAt(q.x, q.y);
    c[1] = c[0] + (uint32_t)size;
    c[2] = c[0] + (uint32_t)size * kCorners;
    c[3] = c[2] + (uint32_t)size;
}

// In which of their marks two corners are alike, a bit for each: kSameId, and kSameMarks for all.
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
