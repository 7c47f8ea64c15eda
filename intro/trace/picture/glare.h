// Glare: the light that the lens and the eye spread around bright places, in linear light.
//
// A share of all light is spread over circles, each twice as wide as the one before. All circles get the same
// amount, so what is bright shines over its surroundings. There is no threshold, and no light is added: what
// a place gives to others it loses. The circles come from a pyramid of halved pictures.
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
    static constexpr int kLevels = 7; // of 1/2, 1/4, ... of the picture's sides

    // Rows are `stride` floats apart. The first and the last value of a row are repeated beside it.
    struct Level {
        int width, height, stride;
        float *plane[3];
    } level[kLevels];
    float *memory; // of all of them
};

// Bytes of arena that makeGlare() takes for pictures of up to this size.
size_t glareBytes(int width, int height);
// False if the arena is full.
bool makeGlare(Glare &glare, Arena &arena, int width, int height);

// Fills level 1, a quarter as wide and high as the frame, with the spread light: for each place a mean of the
// frame, with weights that sum to 1.
void spreadGlare(Glare &glare, const Frame &frame, Workers &workers);

} // namespace odraz
