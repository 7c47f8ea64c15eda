// A solved model: the light of every light basis on every texel, with all bounces; and the stages of solving.
//
// Light is linear: the picture at any time is a weighted sum of these bases, skies, suns and lamps. Direct
// light of suns and lamps is kept apart, as one number a texel, so that it can be left out where the tracer
// draws it.
//
// These are the stages, in order. solveRadiosity() goes through all of them for a room that is relit; tools
// go through them with rows of form factors, lights and additional steps of their own:
//   Model::divide()    patches and texels, and what of them is hidden; the caller says what patches reflect
//   findFormFactors()  by hemicubes that OpenGL draws; tools may fill FormFactors in other ways
//   findDirect()       direct light on the texels, which are refined and tied
//   fillSystem()       what patches reflect, and the direct light that arrives there
//   solve()            until little changes; or bounce(), once for each bounce
//   findIndirect()     the indirect light that arrives at patches
//   spreadLight()      from the patches to the texels
#pragma once

#include "base/progress.h"
#include "radiosity/solve.h"

namespace odraz {

struct RadiositySettings {
    int px = 32;   // pixels along the top face of a hemicube
    int block = 3; // width and height of a patch, in undivided cells
    // Cells are divided up to `levels` times (kFinest at most) where some basis changes over them by more
    // than `contrast`, as a share of the root mean square of its light. The film's are not divided
    int levels = 0;
    float contrast = 0.3f;
    float residual = 1e-4f;
    int sweeps = 100;       // at most
    size_t links = 6 << 20; // room for form factors
};

struct Radiosity {
    FormFactors factors;
    System system; // of all bases; columns 3 basis + channel
    LightBases bases;
    float *bounced[kMaxBases][3]; // planes of texels; those of skies include direct light
    float *direct[kMaxBases];     // planes: what share arrives from the sky, the sun or the lamp itself
    Hemicubes hemicubes;          // open as long as the context is
};

// Finds direct light, divides the cells over which it changes much, samples the new texels, and ties.
// `direct` holds one plane of zeros for each basis.
void findDirect(Radiosity &r, Model &model, const Scene &scene, const RadiositySettings &settings,
                Workers &workers, const Progress &progress);

// Makes a system for bases of white light: the direct light of a patch is the mean of its texels. False when
// the arena is full.
bool fillSystem(Radiosity &r, const Model &model, Arena &arena, Workers &workers);

// Adds the indirect light of a system to the planes of its columns. Light of skies may be negative if they
// are functions.
void spreadLight(Radiosity &r, const Model &model, Workers &workers);

// Adds direct light of the skies to their bounced light, and moves all planes as the ties say.
void settleLight(Radiosity &r, const Model &model, Workers &workers);

// Goes through all stages: divides the model and solves it. `scene` is for shadow rays and for the mean
// reflectance of materials, which patches get. False when the arena is too small, OpenGL cannot do it, or the
// viewer left.
bool solveRadiosity(Radiosity &r, Model &model, Scene &scene, const RadiositySettings &settings, const Gl &gl,
                    Arena &arena, Workers &workers, const Progress &progress);

} // namespace odraz
