// The settings for solving a model, most of them options of `solve` and `view`, and callbacks for progress,
// light and saved rows. Areas are in squared units of the model.
#pragma once

#include "radiosity/hemicube.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/radiosity/solution/solution.h"

#include <functional>
#include <string>
#include <string_view>

namespace odraz::radiosity {

// The method of transport: rays from elements (rays/), or hemicubes at patches, as in the film (patches/).
enum class SolveMethod { kRays, kPatches };

// Returns the eye of hemicube k of a patch.
using EyeOf = std::function<Eye(const Model &model, int patch, int k)>;

// Reports progress, on the thread that solves: the current step, the share of it that is done (0 .. 1), and
// the residual during solving (otherwise below 0).
using SolveProgress = std::function<void(const char *step, float done, float residual)>;

// Called when solving by rays, on the thread that solves, with direct light alone, then after every sweep.
// light() computes the light found so far, which takes time, so that it need not be called every time.
using LightWatcher = std::function<void(const std::function<const Solution &()> &light)>;

// Rows of a solution by rays (saved_state.h) that are saved, so that a later run can resume.
struct RowSaving {
    std::function<void(const std::string &rows)> save; // every `seconds` and after a stop; may be null
    double seconds = 60;
    std::string_view resumed; // saved rows to continue from, used in place; empty: none
};

struct SolveSettings {
    SolveMethod method = SolveMethod::kRays;
    double element = 0;   // area of an element; 0: 1/30,000 of the model's, or 1/120,000 with final rays
    int lampSamples = 16; // shadow rays from each sample point to the largest lamp, 1 .. 256
    int bounces = -1;     // number of bounces to follow; -1: until the residual is reached
    float residual = 1e-4f;
    size_t memory = (size_t)8192 << 20; // bytes; a solution that needs more is refused
    Surroundings surroundings;
    bool evenSky = true; // add a sky of radiance 1 if nothing emits light

    // By rays
    int rays = 0;      // rays from each element, up to 32768; 0: the number that each one needs
    int finalRays = 0; // rays from each element in the final gather; 0: no final gather
    RowSaving saving;
    std::function<void(size_t bytes)> needs; // reports the number of bytes needed, before they are allocated

    // Between patches
    int hemicube = 16;    // pixels along the top face, 4 .. kMaxHemicube
    double patch = 0;     // area of a patch; 0: 1/6000 of the model's, or larger if it has many polygons
    bool analytic = true; // find direct light by shadow rays; false: hemicubes see the lamps
    int shots = 0; // above 0: shoot light (shooting.h) with at most this number of hemicubes, without rows
    int each = 1;  // hemicubes of each patch, for measurements; 0: find no rows
    EyeOf eyeOf;   // their eyes; null: all in the middle of the patch

    LightWatcher watcher; // may be null
};

} // namespace odraz::radiosity
