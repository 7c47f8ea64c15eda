// How to solve a model, and the functions called meanwhile: the options of `solve` and `view`. Areas are in
// squared units of the model.
#pragma once

#include "radiosity/hemicube.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/radiosity/solution/solution.h"

#include <functional>
#include <string>
#include <string_view>

namespace odraz::radiosity {

// How light is transported between surfaces: by rays from every element (rays/), or between patches by
// hemicubes that OpenGL draws, as in the film (patches/).
enum class SolveMethod { kRays, kPatches };

// The eye of a patch's hemicube number k.
using EyeOf = std::function<Eye(const Model &model, int patch, int k)>;

// Reports progress, on the thread that solves: the current step, the share of it that is done (0 .. 1), and
// during solving the residual (otherwise below 0). At the end `step` is null.
using SolveProgress = std::function<void(const char *step, float done, float residual)>;

// Receives light during the solution by rays, on the thread that solves: first direct light alone, with
// `bounced` false, then the light after every sweep.
using LightWatcher = std::function<void(const Solution &soFar, bool bounced)>;

struct SolveSettings {
    SolveMethod method = SolveMethod::kRays;
    double element = 0;   // area of an element; 0: 1/30,000 of the model's, with final rays 1/120,000
    int lampSamples = 16; // shadow rays to the largest lamp from each place, 1 .. 256
    int bounces = -1;     // -1: until the residual is reached
    float residual = 1e-4f;
    size_t memory = (size_t)8192 << 20; // bytes; a solution that needs more is refused
    Surroundings surroundings;
    bool evenSky = true; // adds a sky of radiance 1 if nothing emits light

    // By rays
    int rays = 0;      // from an element, up to 32768; 0: the number that each one needs
    int finalRays = 0; // from an element in the final gather; 0: no final gather

    // Between patches
    int hemicube = 16;    // pixels along the top face, 4 .. kMaxHemicube
    double patch = 0;     // area of a patch; 0: 1/6000 of the model's, or larger if it has many polygons
    bool analytic = true; // direct light by shadow rays; false: hemicubes see the lamps
    int shots = 0; // above 0: shoots light (shooting.h) with at most this number of hemicubes, without rows
    // For measurements: the number of hemicubes of each patch, 0 for no rows, and where they stand; null: in
    // its middle
    int each = 1;
    EyeOf eyeOf;

    LightWatcher watcher; // may be null
    std::function<bool()>
        lightIsDue; // whether to compute light for the watcher now, which takes time; null: always
    // By rays: reports the number of bytes needed, before they are allocated
    std::function<void(size_t bytes)> needs;
    // By rays: saves the rows found so far (saved_state.h), every `keepEvery` seconds and after a stop
    std::function<void(const std::string &rows)> keep;
    double keepEvery = 60;
    std::string_view resumed; // saved rows to continue from, which the system may keep using; empty: none
};

} // namespace odraz::radiosity
