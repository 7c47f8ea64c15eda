// A model, solved: what `radiosity solve` does, for the measuring programs as well. The stages are those of
// radiosity/radiosity.h, for one set of lights: what shines in the model, red, green and blue.
#pragma once

#include "radiosity/radiosity.h"
#include "tools/common/clock.h"
#include "tools/radiosity/mesh.h"
#include "tools/radiosity/pictured.h"
#include "tools/radiosity/regions.h"
#include "tools/radiosity/row_finder.h"
#include "tools/radiosity/surroundings.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace odraz {

// How light is passed on: from every element by rays (gather.h), or between patches by hemicubes that OpenGL
// draws, as the film does it.
enum class Way { kRays, kPatches };
struct Bake;
// Hears of light that is worth looking at (growing.h), on the thread that solves: of direct light,
// `radiosity` null; then after every sweep, with the radiosities of the patches as System has them.
using Growing = std::function<void(const Bake &, const float *radiosity)>;

struct BakeSettings {
    Way way = Way::kRays;
    // By rays
    int rays = 0;  // from an element, up to 32768; 0: as many as each one needs
    int final = 0; // from an element in the end, for quality; 0: none
    // By patches
    int hemicube = 16;             // pixels; even, 4 .. kMaxHemicube
    double patch = 0, element = 0; // areas; 0: a 6000th or, of many polygons, more; a
                                   // 30000th of the model's
    int bounces = -1;              // -1: until the residual is reached
    float residual = 1e-4f;
    int lampSamples = 16; // parts of the largest lamp, 1 .. kMaxLampCells
    bool analytic = true; // direct light by shadow rays; else lamps are seen by hemicubes
    bool adaptive = false;
    float contrast = 0.05f; // see RadiositySettings
    size_t memory = (size_t)8192 << 20;
    uint32_t turn = 0; // other rotations of the hemicubes
    int turns = 1;     // hemicubes for each patch, turned otherwise: anti-aliasing
    RowFinder rows;    // null: by hemicubes, as is faster
    Surroundings surroundings;
    Growing growing;
    std::function<bool()> looks; // whether it would look now, since making light takes time; null: yes
    // By rays: hears how much memory is needed, before it is taken
    std::function<void(size_t bytes)> needs;
    // Keeps what there is, now and then and when it is stopped (state.h); `resumed` is what was kept
    std::function<void(const std::string &rows)> keep;
    double keepEvery = 60; // seconds
    std::string resumed;
};

// What is told while it works: which step, how far it is, and while solving what is left to change.
using Told = std::function<void(const char *step, float done, float residual)>;

// How much of solving is done, 0 .. 1: by the logarithm of residuals, from the first to what is asked.
class SolvedShare {
public:
    float operator()(float left, float asked);

private:
    double begin = 0;
};

struct Bake {
    struct Free {
        void operator()(void *memory) const;
    };
    BakeSettings settings;
    std::vector<MeshMaterial> materials;
    std::vector<int> material; // of each chart
    Pictured pictured;
    bool byRays;
    // By rays: charts and facets as regions has them, and what arrives at the texels
    Regions regions;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Rgb> arrives;
    size_t rays; // from a site, in the mean
    int sites;
    // By patches
    std::unique_ptr<void, Free> memory;
    Arena arena;
    std::unique_ptr<Model> model;
    std::unique_ptr<Scene> scene;
    std::vector<Glow> glows;
    Radiosity radiosity; // its bases are red, green and blue, each reflected in its own channel alone
    float *light[3];     // planes of texels: all that arrives; irradiance / pi
    bool whole;          // false: it was stopped, and rows are missing or it is not solved to its end
    int sweeps;
    float left;                     // the residual
    double seconds[5];              // of processor time: dividing, form factors, direct, solving, all
    int rows;                       // hemicubes drawn
    std::vector<std::string> notes; // what users should know, a line each
    static const char *const kSteps[5];

    Rgb reflects(int chart) const; // on average
    Rgb reflectsOf(int cell) const;
    Rgb emits(int chart) const;
};

// Workers watch no abort of their own. Throws ModelError, or std::runtime_error for the rest. A value other
// than 0 in `stop` ends it early: with direct light and what was gathered so far.
std::unique_ptr<Bake> bake(const Mesh &mesh, const BakeSettings &settings, const Gl &gl, Workers &workers,
                           const int *stop, const Told &told);

// How often cells are divided in adaptive solutions; the side of a cell before that.
inline constexpr int kDivided = 2;
static_assert(kDivided <= kFinest);
double cellOf(const Mesh &mesh, const BakeSettings &settings);

// Tells that `resumed` is none of this model's.
[[noreturn]] void refuseKept();

// What it goes through; regions, materials and settings are there.
void bakeByPatches(Bake &b, const Mesh &mesh, const Gl &gl, Workers &workers, const int *stop,
                   const Told &told);
void bakeByRays(Bake &b, const Mesh &mesh, Workers &workers, const int *stop, const Told &told);

} // namespace odraz
