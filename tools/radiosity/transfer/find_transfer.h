// Finds the transfer of a model: solves it by rays for each function of the bands and for each lamp.
//
// A lamp is all triangles of one emitting material, a ball, or a sun of the settings. If there are more than
// kMaxLamps lamps, the last one combines the rest.
#pragma once

#include "tools/radiosity/solution/solve_settings.h"
#include "tools/radiosity/solution/solve_task.h"
#include "tools/radiosity/transfer/transfer_room.h"

namespace odraz::radiosity {

struct TransferSettings {
    int bands = kBands;
    int clusters = 0, rank = 0;            // 0: enough for an error below one per cent
    std::string glossy;                    // name of a material; empty: none
    float polish = kPolish, exponent = 16; // see gloss.h, and window() of spherical_harmonics.h
    int glossRays = 4096;                  // rays from the middle of each square of glossy planes
    bool upIsZ = false;
    SolveSettings solve; // its rays, element, lamps, suns, memory and residual are used; its sky is not
};

struct TransferReport {
    size_t sites = 0, raysFromSite = 0;
    int squares = 0;        // number of glossy squares
    double seconds[4] = {}; // processor time of rays, solving, clusters, gloss
    std::vector<std::string> notes;
};

// Column weights for findClusters(), which give the environment and each lamp the same weight.
std::vector<float> columnScale(const TransferRoom &room, const std::vector<float> &rows);

// Clusters of the room's rows: `count`, with `rank` axes each.
Clusters clustersOf(const TransferRoom &room, int count, int rank, Workers &workers);

// Throws ModelError or std::runtime_error.
TransferRoom findTransfer(const Mesh &mesh, const TransferSettings &settings, Workers &workers,
                          const SolveProgress &progress, TransferReport &report);

} // namespace odraz::radiosity
