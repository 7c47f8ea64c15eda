// Clustered principal components: the rows of a matrix, each told by few numbers.
//
// k-means in which a cluster is not a point but an affine subspace: its mean and its leading principal axes.
// A row goes to the cluster into whose subspace its projection is nearest; then row ~ mean + sum of weight *
// axis. Axes are found by block power iteration on the rows themselves, so that neither a covariance of many
// columns nor a Gram matrix of many rows is ever made. Axes that a cluster has no use for (few rows, or all
// in one plane) are zero.
//
// Source: Sloan, Hall, Hart and Snyder, "Clustered Principal Components for Precomputed Radiance Transfer",
// SIGGRAPH 2003.
#pragma once

#include "base/arena.h"
#include "base/float8.h"
#include "base/parallel.h"

namespace odraz {

struct PcaSettings {
    int clusters;       // 1 ..
    int dimensions;     // 0 .. kMaxDimensions, a multiple of 8
    int rounds = 3;     // of k-means: 0 keeps the clusters as they are given
    int iterations = 4; // of the power method in every round
    int tried = 4;      // a row tries so many clusters, those with the nearest means: 0 .. 8
};
inline constexpr int kMaxDimensions = 32;

struct ClusteredPca {
    int rows, columns, clusters, dimensions; // columns: a multiple of 8
    const float *data;                       // [rows][columns]
    int *cluster;                            // of every row
    float *axes;    // [clusters][1 + dimensions][columns]: the mean, then unit vectors
    float *weights; // [rows][dimensions]
    int *members,
        *first; // rows in the order of their clusters, and where each cluster's begin: [clusters + 1]

    const float *axesOf(int c) const { return axes + (size_t)c * (size_t)(1 + dimensions) * (size_t)columns; }
};

// Compresses rows that begin in the clusters given by `p.cluster` (0 .. settings.clusters - 1), which is
// changed; p.data, p.rows and p.columns are set. False when the arena is full.
bool compress(ClusteredPca &p, const PcaSettings &settings, Arena &arena, Workers &workers);

} // namespace odraz
