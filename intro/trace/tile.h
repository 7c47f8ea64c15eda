// A tile of the frame while it is being traced: its corners and squares, and the pixels that they fill.
//
// Places are pixels from the tile's upper left corner. Corners lie on the pixels' own corners, so that a tile
// of kTile pixels has kTile + 1 of them along a side; it shares the outer ones with its neighbours, which
// trace them anew.
#pragma once

#include "trace/adaptive.h"

namespace odraz {

inline constexpr int kCorners = kTile + 1;
inline constexpr int kGrains = 192; // small shapes that a tile can watch for
inline constexpr uint16_t kMixed = 0xffff;

// A square of the tile, by its upper left corner.
struct Square {
    uint8_t x, y;
};

// A shape that may slip between the corners: in the picture a disc, or where it is long and thin all that
// lies within the radius of a line.
struct Grain {
    float x, y, alongX, alongY, radius; // one end, the way to the other, in pixels
};

struct TileScratch {
    TraceScratch trace;
    Sample corners[kCorners * kCorners];
    Rgb shown[kCorners * kCorners]; // intensities of corners as the eye weighs them, texture left out
    uint8_t traced[kCorners * kCorners];
    // Corners wanted next
    uint32_t wanted[kCorners * kCorners];
    int wantedCount;
    Square squares[2][kTile * kTile];
    // The filled tile, pixel by pixel: interpolated light and rest, and whose albedo joins them (kMixed:
    // none)
    float light[3][kTile * kTile + 8], rest[3][kTile * kTile + 8];
    uint16_t owner[kTile * kTile];
    uint16_t pixels[kTile * kTile];    // to super-sample
    Square middles[kTile * kTile / 4]; // squares of 2 pixels with a sample in the middle
    Sample fine[kChunk];
    Grain grains[kGrains];
    int grainCount;
    int64_t sampleCount;
};

struct Tile {
    TileScratch &s;
    const Scene &scene;
    const View &view;
    const Quality &quality;
    Frame &frame;
    int x0, y0, width, height; // the part of the frame that it covers
};

// Radiance on a scale on which equal steps look about equally large.
inline Rgb shown(const Scene &scene, Rgb radiance) {
    auto curve = [](float x) { return sqrt(x / (x + 0.7f)); };
    Rgb v = radiance * scene.exposure;
    return {curve(v.x), curve(v.y), curve(v.z)};
}

// The largest difference between `count` colours in one channel.
inline float range(const Rgb *const *v, int count) {
    Rgb lo = *v[0], hi = lo;
    for (int i = 1; i < count; ++i) {
        lo = {min(lo.x, v[i]->x), min(lo.y, v[i]->y), min(lo.z, v[i]->z)};
        hi = {max(hi.x, v[i]->x), max(hi.y, v[i]->y), max(hi.z, v[i]->z)};
    }
    return maxComponent(hi - lo);
}

// Indices of a square's corners: upper left, upper right, lower left, lower right.
inline void cornersOf(Square q, int size, int *c) {
    c[0] = q.y * kCorners + q.x;
    c[1] = c[0] + size;
    c[2] = c[0] + size * kCorners;
    c[3] = c[2] + size;
}

// Whether a square's corners show different things: the first of the thesis's four tests.
inline bool onSilhouette(const TileScratch &s, const int *c) {
    for (int i = 1; i < 4; ++i)
        if (s.corners[c[i]].id != s.corners[c[0]].id) return true;
    return false;
}

// --- fill.cpp: from corners to pixels ---

// Interpolates a square over the pixels it covers.
void fill(Tile &t, Square q, int size);

// Fills a square of 2x2 pixels that has a fifth sample in its middle: every pixel lies between that and a
// corner.
void fillByMiddle(Tile &t, Square q);

// Lets the first `count` of the listed pixels be the mean of side x side samples each (side <= 16); returns
// how many are left listed because their samples still differ by more than the threshold.
int superSample(Tile &t, int count, int side, float threshold);

// Multiplies every pixel's light by the albedo it sees, and writes the tile into the frame.
void finishTile(Tile &t);

} // namespace odraz
