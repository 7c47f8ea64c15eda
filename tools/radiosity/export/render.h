// Traces a picture of a solution from a camera.
#pragma once

#include "base/parallel.h"
#include "tools/engine/heap_arena.h"
#include "tools/radiosity/solution/solution.h"
#include "trace/picture/frame.h"

#include <utility>

namespace odraz::radiosity {

struct RenderSettings {
    Vec3 eye, target; // in the solution's coordinates
    Vec3 place = {};  // Solution::place
    bool upIsZ = false;
    float lens = 60; // vertical field of view, degrees
    int width = 1280, height = 720;
    bool logarithmic = false; // shows the logarithm of radiosity; otherwise uses the film's curve
    float stops = 0;          // powers of two added to the automatic exposure
    float constant = 0; // above 0: shows radiosity times this linearly, 1 is white, without curve or exposure
};

// A frame of the film's tracer.
struct HeapFrame {
    HeapArena memory;
    Frame frame = {};

    // Throws std::runtime_error if there is not enough memory.
    HeapFrame(int width, int height);
    const float &at(int plane, int x, int y) const {
        return frame.plane[plane][(size_t)y * (size_t)frame.stride + (size_t)x];
    }
    float &at(int plane, int x, int y) { return const_cast<float &>(std::as_const(*this).at(plane, x, y)); }
    std::vector<Rgb> pixels() const; // in rows from top to bottom
};

// Places the camera above and to one side, so that the picture holds all facets.
void placeCamera(const Solution &solution, RenderSettings &settings);

// A colour, 0 .. 1 and no longer linear, whose brightness is the position of its logarithm between `low` and
// `high`.
Rgb logarithmicTone(const Rgb &light, float low, float high);

// Writes a PNG. Throws std::runtime_error.
void render(const Solution &solution, const RenderSettings &settings, Workers &workers,
            const std::string &path);

} // namespace odraz::radiosity
