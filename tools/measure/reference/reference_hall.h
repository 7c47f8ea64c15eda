// The film's hall, solved for a measurement or a test.
#pragma once

#include "show/hall.h"
#include "tools/support/heap_arena.h"

#include <functional>
#include <memory>
#include <vector>

namespace odraz::measure {

// The red, green and blue planes that relight() writes, a float per texel.
struct TexelPlanes {
    explicit TexelPlanes(int texels) {
        for (size_t c = 0; c < 3; ++c) {
            values[c].resize((size_t)texels + 8);
            plane[c] = values[c].data();
        }
    }
    TexelPlanes(const TexelPlanes &) = delete; // plane[] points into values[]
    std::vector<float> values[3];
    float *plane[3];
};

// The hall, solved with the given settings.
struct SolvedHall {
    // `change` may change the hall before it is solved. Throws std::runtime_error.
    SolvedHall(const RadiositySettings &settings, const HemicubeMethod &method, const Gl &gl,
               Workers &workers, size_t memory = kRoomBytes, const std::function<void(Hall &)> &change = {},
               const Progress &progress = {});

    // Computes the glossy transfer of the floor. Throws std::runtime_error if the arena is full.
    void solveGloss(Arena &arena, Workers &workers);

    HeapArena memory;
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Hall> hall;
    double seconds; // processor time of solving
};

} // namespace odraz::measure
