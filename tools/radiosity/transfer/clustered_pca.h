// Clustered principal component analysis: compresses each row of a matrix to a few numbers.
//
// This is k-means with affine subspaces instead of points: a cluster is a mean and the leading principal
// axes. Each row belongs to the cluster with the nearest subspace, and is approximated by the mean plus the
// sum of weight * axis. Block power iteration on the rows finds the axes. It needs neither a covariance
// matrix over many columns nor a Gram matrix over many rows. If a cluster needs fewer axes (few rows, or rows
// in one plane), the others are zero.
//
// Source: Sloan, Hall, Hart and Snyder, "Clustered Principal Components for Precomputed Radiance Transfer",
// SIGGRAPH 2003.
#pragma once

#include "base/arena.h"
#include "base/float8.h"
#include "base/parallel.h"

namespace odraz::radiosity {

struct PcaSettings {
    int clusters;       // 1 ..
    int dimensions;     // 0 .. kMaxDimensions, a multiple of 8
    int rounds = 3;     // rounds of k-means; 0 keeps the given clusters
    int iterations = 4; // steps of the power method in each round
    int tried = 4;      // candidates for a row, the clusters with the nearest means: 0 .. 8
};
inline constexpr int kMaxDimensions = 32;

struct ClusteredPca {
    int rows, columns, clusters, dimensions; // columns: a multiple of 8
    const float *data;                       // [rows][columns]
    int *cluster;                            // each row's cluster: [rows]
    float *axes;    // [clusters][1 + dimensions][columns]: the mean, then unit vectors
    float *weights; // [rows][dimensions]
    int *members;   // rows in the order of their clusters: [rows]
    int *first;     // each cluster's first index in `members`: [clusters + 1]

    const float *axesOf(int c) const { return axes + (size_t)c * (size_t)(1 + dimensions) * (size_t)columns; }
};

// Number of bytes that compress() takes from its arena.
inline size_t compressBytes(int rows, int columns, const PcaSettings &s) {
    return ((size_t)s.clusters * ((size_t)(1 + s.dimensions) * (size_t)columns + 1) +
            (size_t)rows * (size_t)(s.dimensions + 1)) *
               sizeof(float) +
           4096;
}

// Compresses the rows. The caller sets p.data, p.rows and p.columns, and p.cluster with each row's initial
// cluster (0 .. settings.clusters - 1), which compress() changes. Returns false if the arena is full.
bool compress(ClusteredPca &p, const PcaSettings &settings, Arena &arena, Workers &workers);

} // namespace odraz::radiosity
