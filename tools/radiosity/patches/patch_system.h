// The system for solving between patches: the model and its radiosity as in the film's stages
// (radiosity/radiosity.h), with the memory that they need. The bases are red, green and blue; each is
// reflected only in its own channel.
#pragma once

#include "radiosity/radiosity.h"
#include "tools/engine/machine.h"
#include "tools/radiosity/solution/solve_task.h"

#include <memory>

namespace odraz::radiosity {

struct PatchSystem {
    // Throws std::runtime_error if there is not enough memory.
    explicit PatchSystem(size_t bytes);
    PatchSystem(const PatchSystem &) = delete;

    struct Unmap {
        size_t bytes;
        void operator()(void *memory) const;
    };
    std::unique_ptr<void, Unmap> memory; // of the arena
    Arena arena;
    std::unique_ptr<Model> model;
    std::unique_ptr<Scene> scene;
    std::vector<Glow> glows; // facets that emit
    Radiosity radiosity = {};
    float *light[3] = {}; // planes of texels: all light that arrives, irradiance / pi

    // A patch's colour in a matrix of the system, [patches][columns]: red in the red basis, and so on.
    Rgb colourIn(const float *matrix, int patch) const {
        const float *v = matrix + (size_t)patch * (size_t)radiosity.system.columns;
        return {v[0], v[4], v[8]};
    }
    void setColour(float *matrix, int patch, const Rgb &c) const {
        float *v = matrix + (size_t)patch * (size_t)radiosity.system.columns;
        v[0] = c.x, v[4] = c.y, v[8] = c.z;
    }
    // The matrix of the light that rows bring from lamps. `emits`: the emission of charts.
    std::vector<float> lampsSeen(const std::vector<Rgb> &emits, Workers &workers) const;
};

// If lamps have more facets than this, hemicubes are the better way to find their light.
inline constexpr size_t kManyLamps = 256;
// The facets that emit, for direct light. The largest has `samples` parts, others fewer in proportion to
// their area.
std::vector<Glow> findLamps(const Mesh &mesh, const Regions &regions, const Model &model, int samples);

// Solves a model between patches, with the stages that light the film's hall. Fills task.solution and
// task.report. Returns the system, for programs that measure it. Throws std::runtime_error, ModelError.
std::unique_ptr<PatchSystem> solveByPatches(SolveTask &task, const Gl &gl);

} // namespace odraz::radiosity
