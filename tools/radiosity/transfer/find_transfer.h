// Finds the transfer of a model: solves it for every band of an environment and for each of its lamps, by
// rays.
//
// A lamp is all triangles of one material that emits, a ball or a sun of the settings. With more than
// kMaxLamps of them, the last one stands for all others together.
#pragma once

#include "tools/radiosity/solution/solve_settings.h"
#include "tools/radiosity/solution/solve_task.h"
#include "tools/radiosity/transfer/transfer_room.h"

namespace odraz::radiosity {

struct TransferSettings {
    int bands = kBands;
    int clusters = 0, rank = 0;            // 0: the number that keeps the error below one per cent
    std::string glossy;                    // a material; empty: none is
    float polish = kPolish, exponent = 16; // see gloss.h, and window() of spherical_harmonics.h
    int glossRays = 4096;                  // from the middle of each square of the glossy planes
    bool upIsZ = false;
    // Its rays, element, lamps, suns, memory and residual count; the sky does not
    SolveSettings solve;
};

struct TransferReport {
    size_t sites = 0, raysFromSite = 0;
    int sweeps = 0, squares = 0; // of gloss
    double seconds[4] = {};      // processor time: rows of rays, columns, clusters, gloss
    std::vector<std::string> notes;
};

// The number of clusters for a room of this number of texels, and of axes.
int usualClusters(size_t texels, int bands);
int usualRank(int bands);

// The rays from every site, unless the settings give their number: 256, fewer for many sites.
int usualRays(size_t sites);

// Column weights for the clusters: environment and lamps count alike.
std::vector<float> columnScale(const TransferRoom &room, const std::vector<float> &rows);

// Reports progress: a step and its share done. Throws ModelError, Refused, or std::runtime_error.
TransferRoom findTransfer(const Mesh &mesh, const TransferSettings &settings, Workers &workers,
                          const std::function<void(const char *step, float done)> &progress,
                          TransferReport &report);

} // namespace odraz::radiosity
