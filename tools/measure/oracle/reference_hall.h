// The film's hall, solved for a tool or a test.
#pragma once

#include "show/hall.h"
#include "tools/engine/heap_arena.h"

#include <functional>
#include <memory>
#include <vector>

namespace odraz::measure {

// Planes of the texels' red, green and blue, for relight().
struct TexelPlanes {
    explicit TexelPlanes(int texels) {
        for (size_t c = 0; c < 3; ++c) {
            values[c].resize((size_t)texels + 8);
            plane[c] = values[c].data();
        }
    }
    TexelPlanes(const TexelPlanes &) = delete; // the pointers are its own
    std::vector<float> values[3];
    float *plane[3];
};

// The hall, solved with some settings. Throws std::runtime_error.
struct SolvedHall {
    // `change` may change the light bases before the hall is solved
    SolvedHall(const RadiositySettings &settings, const Gl &gl, Workers &workers, size_t memory = kRoomBytes,
               const std::function<void(LightBases &)> &change = {}, const Progress &progress = {});

    // Computes the floor's gloss. Throws std::runtime_error if the arena is full.
    void polish(Arena &arena, Workers &workers);

    HeapArena memory;
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Hall> hall;
    double seconds; // of processor time
};

} // namespace odraz::measure
