// Finds the transfer of a model: solves it by rays for every band of an environment and for each of its
// lamps.
//
// A lamp is all triangles of one material that emits, a ball, or a sun of the settings. If there are more
// than kMaxLamps, the last one combines all others.
#pragma once

#include "tools/radiosity/solution/solve_settings.h"
#include "tools/radiosity/solution/solve_task.h"
#include "tools/radiosity/transfer/transfer_room.h"

namespace odraz::radiosity {

struct TransferSettings {
    int bands = kBands;
    int clusters = 0, rank = 0;            // 0: the number that keeps the error below one per cent
    std::string glossy;                    // a material; empty: none
    float polish = kPolish, exponent = 16; // see gloss.h, and window() of spherical_harmonics.h
    int glossRays = 4096;                  // from the middle of each square of glossy planes
    bool upIsZ = false;
    // Its rays, element, lamps, suns, memory and residual are used; its sky is not
    SolveSettings solve;
};

struct TransferReport {
    size_t sites = 0, raysFromSite = 0;
    int squares = 0;        // glossy squares
    double seconds[4] = {}; // processor time: rows of rays, columns, clusters, gloss
    std::vector<std::string> notes;
};

// The default number of clusters for this number of texels, and of axes.
int usualClusters(size_t texels, int bands);
int usualRank(int bands);

// The default number of rays from every site: 256, fewer for many sites.
int usualRays(size_t sites);

// Column weights for the clusters, which make environment and lamps equally important.
std::vector<float> columnScale(const TransferRoom &room, const std::vector<float> &rows);

// Reports progress: a step and the share of it that is done. Throws ModelError, Refused, or
// std::runtime_error.
TransferRoom findTransfer(const Mesh &mesh, const TransferSettings &settings, Workers &workers,
                          const std::function<void(const char *step, float done)> &progress,
                          TransferReport &report);

} // namespace odraz::radiosity
