// The system for solving between patches: the model and its radiosity as in the film's stages
// (radiosity/radiosity.h), with the memory that they need. The bases are red, green and blue; each is
// reflected only in its own channel.
#pragma once

#include "radiosity/radiosity.h"

#include <memory>
#include <vector>

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
};

} // namespace odraz::radiosity
