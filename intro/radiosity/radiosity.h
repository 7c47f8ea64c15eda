// A room, solved: for every light its light on every texel, bounces and all.
//
// Light is linear: the picture at any time is a weighted sum of these bases, skies, suns and lamps. Direct
// light of suns and lamps is kept apart, as one number a texel, so that it can be left out where the tracer
// draws it, or put in.
#pragma once

#include "base/progress.h"
#include "radiosity/solve.h"
#include "radiosity/spread.h"
#include "radiosity/ties.h"

namespace odraz {

using Bases = unsigned __int128; // a set of them: a bit for each
static_assert(kMaxBases <= 128);

struct RadiositySettings {
    int px = 32;   // of a hemicube
    int block = 3; // a patch is so many undivided cells wide and high
    // Cells are divided up to so often, kFinest at most, where some basis changes over them by more than
    // `contrast`, as a share of the root mean square of its light; but for suns and lamps that the tracer
    // draws
    int levels = 0;
    float contrast = 0.3f;
    Bases traced = 0;
    float residual = 1e-4f;
    int sweeps = 100;       // no more than these
    size_t links = 6 << 20; // room for form factors
};

struct Radiosity {
    Lights lights;
    FormFactors factors;
    System system;                // of all bases; columns 3 basis + channel
    float *bounced[kMaxBases][3]; // planes of texels; of skies all that arrives, direct light too
    float *direct[kMaxBases];     // planes: what share arrives from the sky, the sun or the lamp itself
    Hemicubes hemicubes;          // open as long as the context is
};

// Divides the model and solves it; `scene` is used for shadow rays. False when the arena is too small, OpenGL
// cannot do it, or the viewer left.
bool solveRadiosity(Radiosity &r, Model &model, Scene &scene, const RadiositySettings &settings, const Gl &gl,
                    Arena &arena, Workers &workers, const Progress &progress);

} // namespace odraz
