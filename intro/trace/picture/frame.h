// The picture: planes of linear radiance, which the tracer fills, and the developed picture.
#pragma once

#include "base/arena.h"

namespace odraz {

inline constexpr int kMaxWidth = 7680, kMaxHeight = 4320;

// Planes of linear red, green and blue, rows `stride` floats apart (a multiple of 8, at least the width).
struct Frame {
    int width, height, stride;
    float *plane[3];
    // Null, or the shape that each pixel shows, kManyShapes or kSkyShown; for in-betweens, tools and tests
    uint16_t *shapes;
    uint8_t *rgba; // width * height * 4 bytes, sRGB, top row first; made by develop()
    // Null, or for in-betweens what each pixel and its right, lower and lower right neighbours show: in the
    // low 16 bits a shape, kSkyShown or kManyShapes; above them 2 if all four pixels show it, 1 if some of
    // them show kManyShapes, 0 if they show several shapes
    int32_t *quads = nullptr;
};

inline constexpr uint16_t kManyShapes = 0xffff, kSkyShown = 0xfffe;

// Bytes before rgba, for a file's header, and after it, which enlarge() may read.
inline constexpr int kPictureMargin = 64;

// Takes the memory for frames of up to this size. Returns false if the arena is full.
bool makeFrame(Frame &frame, Arena &arena, int width, int height);

// Gives the frame another size, in the same memory.
void resize(Frame &frame, int width, int height);

} // namespace odraz
