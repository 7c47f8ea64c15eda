// The picture: linear radiance as the tracer leaves it, then film curve, sRGB and eight bits.
#pragma once

#include "base/arena.h"
#include "base/parallel.h"
#include "base/vec3.h"

namespace odraz {

inline constexpr int kMaxWidth = 7680, kMaxHeight = 4320;

// Planes of linear red, green and blue, rows `stride` floats apart (a multiple of 8, at least the width).
struct Frame {
    int width, height, stride;
    float *plane[3];
    uint16_t *shapes; // null, or for tools and tests: which shape a pixel shows, kManyShapes or kSkyShown
    uint8_t *rgba;    // width * height * 4 bytes, sRGB, top row first; made by develop()
};

inline constexpr uint16_t kManyShapes = 0xffff, kSkyShown = 0xfffe;

// Free bytes before rgba, for a file's header.
inline constexpr int kPictureMargin = 64;

// Takes the memory for frames of up to this size; false when the arena is full.
bool makeFrame(Frame &frame, Arena &arena, int width, int height);

// The film curve: 0 -> 0, rising, infinity -> 1; 0.18 -> 0.26, 1 -> 0.78. x >= 0, NaN gives 0.
Float8 filmic(Float8 x);

// Encodes [0, 1] after IEC 61966-2-1.
Float8 encodeSrgb(Float8 x);

// Fills frame.rgba: radiance * exposure through the film curve to sRGB. Half a bit of fixed noise hides the
// steps.
void develop(Frame &frame, Workers &workers, float exposure);

} // namespace odraz
