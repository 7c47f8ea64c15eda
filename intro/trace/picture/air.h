// The air, and the lens: what lies between the picture and the eye, in linear light.
//
// Glare: a share of all light is scattered about, over wider and wider circles that get the same each, so
// that what is bright shines over its surroundings. It has no threshold, and takes from a place what it gives
// to others. The circles come from a pyramid of halved pictures. Vignette: the picture darkens towards its
// corners. Grain: noise of light, which moves. Sources: Spencer, Shirley, Zimmerman and Greenberg,
// "Physically-Based Glare Effects for Digital Images", SIGGRAPH 95, for the shape; Jimenez, "Next Generation
// Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014 courses, for the pyramid.
#pragma once

#include "base/arena.h"
#include "base/float8.h"
#include "base/parallel.h"
#include "trace/picture/frame.h"

namespace odraz {

struct AirLook {
    float glare;    // share of light that is scattered, 0 .. 1
    float vignette; // what the corners lose, 0 .. 1
    int grain;      // half the width of the noise, 1/32 of one of 255 steps
};
inline constexpr AirLook kNoAir = {0, 0, 0};

struct Air {
    static constexpr int kLevels = 7; // of a half, a quarter, .. of the picture's sides

    // Planes with rows `stride` floats apart; before and behind each row its ends are repeated.
    struct Level {
        int width, height, stride;
        float *plane[3];
    } level[kLevels];
};

// Bytes of arena that makeAir() takes for pictures of a size.
size_t airBytes(int width, int height);
// False where the arena is full.
bool makeAir(Air &air, Arena &arena, int width, int height);

// Leaves in level 1 what each place gets of a frame's light: weights that sum to 1.
void scatterLight(Air &air, const Frame &frame, Workers &workers);

} // namespace odraz
