// Clustered principal component analysis: compresses each row of a matrix, the lights of a texel, to a few
// numbers.
//
// This is k-means with affine subspaces instead of points: a cluster is a mean and the leading principal
// axes. Each row belongs to the cluster with the nearest subspace, and is approximated by the mean plus the
// sum of weight * axis. Block power iteration on the rows finds the axes. It needs neither a covariance
// matrix over many columns nor a Gram matrix over many rows. Axes are sorted by the variance that they
// explain, so that any number of the first axes can be used. If a cluster needs fewer axes (few rows, or rows
// in one plane), the others are zero.
//
// Source: Sloan, Hall, Hart and Snyder, "Clustered Principal Components for Precomputed Radiance Transfer",
// SIGGRAPH 2003.
#pragma once

#include "base/parallel.h"

#include <cstddef>
#include <vector>

namespace odraz::radiosity {

struct Solution;

struct Clusters {
    int count = 0, rank = 0, columns = 0; // rank: axes of each cluster, 0 .. kMostRank
    std::vector<int> of;                  // each row's cluster
    std::vector<float> axes;              // [count][1 + rank][columns]: the mean, then the axes
    std::vector<float> weights;           // [rows][rank]

    size_t floats(int used) const { // number of floats to store if `used` axes are stored
        return (size_t)count * (size_t)(1 + used) * (size_t)columns + of.size() * (size_t)used;
    }
    const float *axesOf(int cluster) const {
        return &axes[(size_t)cluster * (size_t)(1 + rank) * (size_t)columns];
    }
};

inline constexpr int kMostClusters = 4096, kMostRank = 32;

struct ClusterSettings {
    int count, rank;
    int rounds = 3;     // rounds of k-means; 0 keeps the seeds
    int iterations = 4; // steps of the power method in each round
    int tried = 4;      // candidates for a row, the clusters with the nearest means: 0 .. 8
};

// Compresses a matrix of `columns` columns (a multiple of 8). `scale`, above 0, weights the error of each
// column. `seeds`: each row's initial cluster, 0 .. count - 1.
Clusters findClusters(std::vector<float> rows, int columns, const std::vector<float> &scale,
                      std::vector<int> seeds, const ClusterSettings &settings, Workers &workers);

// Seeds for findClusters(): blocks of equal size, by position and by normal times 0.35 of the model's size.
std::vector<int> blocksOf(const Solution &model, int count);

// The rms error of rows with the first `rank` axes, as a share of the rows' rms, weighted by `scale`.
double compressionError(const Clusters &clusters, const std::vector<float> &rows,
                        const std::vector<float> &scale, int rank);

} // namespace odraz::radiosity
