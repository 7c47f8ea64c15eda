// A solved model: the light of every light basis on every texel, with all bounces; and the stages of solving.
//
// Light is linear: the picture at any time is a weighted sum of these bases, skies, suns and lamps. Direct
// light of suns and lamps is kept apart, as one number a texel, so that it can be left out where the tracer
// draws it.
//
// These are the stages, in order. solveRadiosity() goes through all of them for a room that is relit:
//   Model::divide()    patches and texels
//   findVisible()      what of them is hidden, so that Model::placePatches() can place hemicubes
//   findFormFactors()  by hemicubes that OpenGL draws
//   findDirectLight()  direct light on the texels
//   tie()              hidden texels to those around them
//   solve()            until little changes
//   findIndirect()     the indirect light that arrives at patches
//   fillPatches(), addToTexels()  from the patches to the texels
#pragma once

#include "base/progress.h"
#include "radiosity/solve.h"

namespace odraz {

struct RadiositySettings {
    int px = 32;   // pixels along the top face of a hemicube
    int block = 3; // width and height of a patch, in cells
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

// Goes through all stages: divides the model and solves it. `scene` is for shadow rays and for the mean
// reflectance of materials, which patches get. False when the arena is too small, OpenGL cannot do it, or the
// viewer left.
bool solveRadiosity(Radiosity &r, Model &model, Scene &scene, const RadiositySettings &settings, const Gl &gl,
                    Arena &arena, Workers &workers, const Progress &progress);

} // namespace odraz
