// A room's rows, compressed by clustered PCA (clustered_pca.h): each texel has a cluster and a few weights,
// and each cluster a mean and axes.
//
// Axes are put in the order of what they explain, so that the first few of them are the best few, and any
// number of them can be used. A cluster with fewer axes has zeros for the others.
#pragma once

#include "base/parallel.h"
#include "radiosity/model.h"

#include <cstddef>
#include <span>
#include <vector>

namespace odraz::radiosity {

struct Solution;

struct Clusters {
    int count = 0, rank = 0, columns = 0; // rank: axes of each, 0 .. 32
    std::vector<int> of;                  // the cluster of each texel
    std::vector<float> axes;              // [count][1 + rank][columns]: the mean, then the axes
    std::vector<float> weights;           // [texels][rank]

    size_t floats(int used) const { // that are kept if `used` axes are
        return (size_t)count * (size_t)(1 + used) * (size_t)columns + of.size() * (size_t)used;
    }
    const float *axesOf(int cluster) const {
        return &axes[(size_t)cluster * (size_t)(1 + rank) * (size_t)columns];
    }
};

inline constexpr int kMostClusters = 4096, kMostRank = 32;

// The compression of a matrix of `columns` columns (a multiple of 8), whose error counts in each column times
// its `scale`, above 0. `seeds` is where each row starts (0 .. count - 1). Throws std::runtime_error if
// memory is short.
Clusters findClusters(const std::vector<float> &rows, int columns, const std::vector<float> &scale,
                      std::vector<int> seeds, int count, int rank, Workers &workers);

// Divides texels into blocks of equal size, by their places and normals: seeds. `normal`: the length, in
// world units, that a normal counts as; 0: 0.35 of the model's size.
std::vector<int> blocksOf(std::span<const Texel> texels, const Chart *charts, int count, float normal = 0);
std::vector<int> blocksOf(const Solution &model, int count);

// The root mean square of what a row loses with the first `rank` axes, as a share of the rows' own; columns
// count times `scale`.
double lossOf(const Clusters &clusters, const std::vector<float> &rows, const std::vector<float> &scale,
              int rank);

} // namespace odraz::radiosity
