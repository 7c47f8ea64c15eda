// The film's hall, and what its light is compared with: three of its lights, gathered by rays alone.
#pragma once

#include "show/hall.h"
#include "tools/common/heap_arena.h"
#include "tools/measure/reference.h"

namespace odraz {

// Red, green and blue of texels, for relight().
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
    // `change` may put other lights into it before it is solved
    SolvedHall(const RadiositySettings &settings, const Gl &gl, Workers &workers, size_t memory = kRoomBytes,
               const std::function<void(Lights &)> &change = {}, const Progress &progress = {});

    // Finds the floor's gloss. Throws std::runtime_error where the arena is full.
    void polish(const GlossySettings &settings, Arena &arena, Workers &workers);

    HeapArena memory;
    std::unique_ptr<Scene> scene;
    std::unique_ptr<Hall> hall;
    double seconds; // of processor time
};

// Probes for noon (the sky and the sun's bounces), a lantern (its bounces) and a strip (all of it), from a
// fine solution.
std::array<std::vector<Probe>, 3> gatherHall(const SolvedHall &fine, int count, int side, Workers &workers);

// Root mean square over all three, each as a share of its own light; percent.
double rmsPercent(const SolvedHall &solved, const std::array<std::vector<Probe>, 3> &probes);

} // namespace odraz
