// A solved model: the light of every light basis on every texel, with all bounces; and the stages of solving.
//
// Light is linear: at any time it is a weighted sum of the light of these bases: skies, suns and lamps.
// Direct light of suns and lamps is separate, one number a texel, so that it can be left out where the tracer
// draws it.
//
// These are the stages, in order. solveRadiosity() runs all of them:
//   Model::divide()    patches and texels
//   findVisible()      their visible parts, so that Model::placePatches() can place hemicubes
//   findFormFactors()  by hemicubes
//   findDirectLight()  direct light on the texels
//   tie()              hidden texels to their neighbours
//   fillPatches()      hidden patches: direct light and a row from their neighbours
//   solve()            the reflected light, until it hardly changes
//   findIndirect()     the indirect light on patches
//   fillPatches(), addToTexels()  from the patches to the texels
#pragma once

#include "base/progress.h"
#include "radiosity/solve.h"

namespace odraz {

struct RadiositySettings {
    int px = 32;   // pixels along the top face of a hemicube
    int block = 3; // width and height of a patch, in cells
    float residual = 1e-4f;
    int sweeps = 100;       // the most sweeps
    size_t links = 6 << 20; // capacity for form factors
};

struct Radiosity {
    FormFactors factors;
    System system; // for all bases; column 3 basis + channel
    LightBases bases;
    float *bounced[kMaxBases][3]; // planes of texels; for skies they include direct light
    float *direct[kMaxBases];     // planes: the share of the basis that arrives directly
    Hemicubes hemicubes;          // open after solveRadiosity()
};

// The resources of solving: how hemicubes are filled, OpenGL in the current context if they are drawn,
// memory, threads, and a report of progress.
struct SolverHost {
    const HemicubeMethod &method;
    const Gl *gl;
    Arena &arena;
    Workers &workers;
    const Progress &progress;
};

// Runs all stages. `scene` is for shadow rays and for the mean reflectances of patches. Returns false if the
// arena is too small, if OpenGL cannot render ids, or if the viewer left.
bool solveRadiosity(Radiosity &r, Model &model, Scene &scene, const RadiositySettings &settings,
                    const SolverHost &host);

} // namespace odraz
