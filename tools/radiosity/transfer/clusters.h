// A room's rows, compressed by clustered PCA: texels have a cluster and weights, clusters a mean and axes.
//
// Axes are sorted by the variance that they explain, so that any number of the first axes can be used. A
// cluster with fewer axes has zeros for the others.
#pragma once

#include "base/parallel.h"
#include "radiosity/model.h"

#include <cstddef>
#include <vector>

namespace odraz::radiosity {

struct Solution;

struct Clusters {
    int count = 0, rank = 0, columns = 0; // rank: axes of each cluster, 0 .. 32
    std::vector<int> of;                  // each texel's cluster
    std::vector<float> axes;              // [count][1 + rank][columns]: the mean, then the axes
    std::vector<float> weights;           // [texels][rank]

    size_t floats(int used) const { // number of floats to store if `used` axes are stored
        return (size_t)count * (size_t)(1 + used) * (size_t)columns + of.size() * (size_t)used;
    }
    const float *axesOf(int cluster) const {
        return &axes[(size_t)cluster * (size_t)(1 + rank) * (size_t)columns];
    }
};

inline constexpr int kMostClusters = 4096, kMostRank = 32;

// Compresses a matrix of `columns` columns (a multiple of 8). `scale`, above 0, weights the error of each
// column. `seeds`: initial clusters, 0 .. count - 1. Throws std::runtime_error if memory is short.
Clusters findClusters(const std::vector<float> &rows, int columns, const std::vector<float> &scale,
                      std::vector<int> seeds, int count, int rank, Workers &workers);

// Seeds for findClusters(): blocks of equal size, by position and by normal times 0.35 of the model's size.
std::vector<int> blocksOf(const Solution &model, int count);

// The rms error of rows with the first `rank` axes, as a share of the rows' rms, weighted by `scale`.
double compressionError(const Clusters &clusters, const std::vector<float> &rows,
                        const std::vector<float> &scale, int rank);

} // namespace odraz::radiosity
