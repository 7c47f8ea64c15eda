// The film's hall, and what its light is compared with: three of its lights, gathered by rays alone.
#pragma once

#include "reference.h"
#include "show/hall.h"

namespace odraz {

// The hall, solved with some settings. Throws std::runtime_error.
struct SolvedHall {
    // `change` may put other lights into it before it is solved
    SolvedHall(const RadiositySettings &settings, const Gl &gl, Workers &workers, size_t memory = hallBytes(),
               const std::function<void(Lights &)> &change = {}, const Progress &progress = {});

    std::unique_ptr<unsigned char[]> memory;
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
