// Glare: the light that the lens and the eye spread around bright places, in linear light.
//
// A share of each pixel's light is spread over circles, each twice as wide as the one before. All circles get
// the same amount, so bright pixels shine over their surroundings. There is no threshold, and no light is
// added: a pixel loses what it gives to others. The circles come from a pyramid of halved pictures.
// Sources: Spencer, Shirley, Zimmerman and Greenberg, "Physically-Based Glare Effects for Digital Images",
// SIGGRAPH 95, for the shape; Jimenez, "Next Generation Post Processing in Call of Duty: Advanced Warfare",
// SIGGRAPH 2014 courses, for the pyramid.
#pragma once

#include "base/arena.h"
#include "base/float8.h"
#include "base/parallel.h"
#include "trace/picture/frame.h"

namespace odraz {

struct Glare {
    static constexpr int kLevels = 7; // their sides are 1/2, 1/4, ... of the picture's

    // Rows are `stride` floats apart. The first value of a row is repeated before it, the last one after it.
    struct Level {
        int width, height, stride;
        float *plane[3];
    } level[kLevels];
    float *memory; // holds all levels
};

// Bytes of arena that makeGlare() takes for pictures of up to this size.
size_t glareBytes(int width, int height);
// Returns false if the arena is full.
bool makeGlare(Glare &glare, Arena &arena, int width, int height);

// Fills level 1, a quarter as wide and high as the frame, with the spread light: each value is a mean of the
// frame, with weights that sum to 1.
void spreadGlare(Glare &glare, const Frame &frame, Workers &workers);

} // namespace odraz
