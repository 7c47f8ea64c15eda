// Traces a picture of a solution from a camera.
#pragma once

#include "base/parallel.h"
#include "tools/radiosity/solution/solution.h"
#include "tools/support/heap_arena.h"
#include "trace/picture/frame.h"

#include <utility>

namespace odraz::radiosity {

struct RenderSettings {
    Vec3 eye, target; // relative to `origin`
    Vec3 origin = {}; // Solution::origin
    bool upIsZ = false;
    float lens = 60; // vertical field of view, degrees
    int width = 1280, height = 720;
    bool logarithmic = false; // show the logarithm of radiosity; otherwise use the film's curve
    float stops = 0;          // the automatic exposure is multiplied by 2^stops
    float constant = 0; // above 0: show radiosity times this constant, without curve or exposure; 1 is white
};

// A frame of the film's tracer, with its memory.
struct HeapFrame {
    HeapArena memory;
    Frame frame = {};

    // Throws std::runtime_error if there is not enough memory.
    HeapFrame(int width, int height);
    const float &at(int plane, int x, int y) const {
        return frame.plane[plane][(size_t)y * (size_t)frame.stride + (size_t)x];
    }
    float &at(int plane, int x, int y) { return const_cast<float &>(std::as_const(*this).at(plane, x, y)); }
    std::vector<Rgb> pixels() const; // rows from top to bottom
};

// Places the camera so that the picture shows all facets: before the open side of a room that has five walls,
// else above the model and to one side.
void placeCamera(const Solution &solution, RenderSettings &settings);

// Tone-maps light to a colour from 0 to 1 (not linear), whose brightness is the position of the light's
// logarithm between `low` and `high`.
Rgb logarithmicTone(const Rgb &light, float low, float high);

// Renders a picture and writes it as PNG, or as OpenEXR, with linear radiance. Throws std::runtime_error.
void render(const Solution &solution, const RenderSettings &settings, Workers &workers,
            const std::string &path);

} // namespace odraz::radiosity
