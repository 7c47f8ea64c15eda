// A room's rows, compressed by clustered PCA (clustered_pca.h): each texel has a cluster and a few weights,
// and each cluster a mean and axes.
//
// Axes are sorted by the variance that they explain, so any number of the first ones can be used. A cluster
// with fewer axes has zeros for the others.
#pragma once

#include "base/parallel.h"
#include "radiosity/model.h"

#include <cstddef>
#include <vector>

namespace odraz::radiosity {

struct Solution;

struct Clusters {
    int count = 0, rank = 0, columns = 0; // rank: axes of each, 0 .. 32
    std::vector<int> of;                  // the cluster of each texel
    std::vector<float> axes;              // [count][1 + rank][columns]: the mean, then the axes
    std::vector<float> weights;           // [texels][rank]

    size_t floats(int used) const { // stored if `used` axes are
        return (size_t)count * (size_t)(1 + used) * (size_t)columns + of.size() * (size_t)used;
    }
    const float *axesOf(int cluster) const {
        return &axes[(size_t)cluster * (size_t)(1 + rank) * (size_t)columns];
    }
};

inline constexpr int kMostClusters = 4096, kMostRank = 32;

// Compresses a matrix of `columns` columns (a multiple of 8). A column's error is weighted by its `scale`,
// above 0. `seeds` has each row's initial cluster (0 .. count - 1). Throws std::runtime_error if memory is
// short.
Clusters findClusters(const std::vector<float> &rows, int columns, const std::vector<float> &scale,
                      std::vector<int> seeds, int count, int rank, Workers &workers);

// Seeds for findClusters(): divides texels into blocks of equal size, by places and normals, which are scaled
// to 0.35 of the model's size for this.
std::vector<int> blocksOf(const Solution &model, int count);

// The rms error of the rows with the first `rank` axes, as a share of the rows' rms; columns are weighted by
// `scale`.
double compressionError(const Clusters &clusters, const std::vector<float> &rows,
                        const std::vector<float> &scale, int rank);

} // namespace odraz::radiosity
