// Clustered principal component analysis: compresses the rows of a matrix to a few numbers each.
//
// This is k-means, but a cluster is an affine subspace instead of a point: a mean and the leading principal
// axes. Each row goes to the cluster whose subspace is nearest to it. The row is then approximately mean +
// sum of weight * axis. Block power iteration on the rows themselves finds the axes. So there is no need for
// a covariance matrix over many columns or a Gram matrix over many rows. A cluster that needs fewer axes (few
// rows, or rows in one plane) sets the others to zero.
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
    int rounds = 3;     // of k-means; 0 keeps the given clusters
    int iterations = 4; // of the power method in each round
    int tried = 4;      // a row tries this many clusters, those with the nearest means: 0 .. 8
};
inline constexpr int kMaxDimensions = 32;

struct ClusteredPca {
    int rows, columns, clusters, dimensions; // columns: a multiple of 8
    const float *data;                       // [rows][columns]
    int *cluster;                            // of every row
    float *axes;    // [clusters][1 + dimensions][columns]: the mean, then unit vectors
    float *weights; // [rows][dimensions]
    int *members,
        *first; // rows in the order of their clusters, and where each cluster begins: [clusters + 1]

    const float *axesOf(int c) const { return axes + (size_t)c * (size_t)(1 + dimensions) * (size_t)columns; }
};

// The bytes that compress() takes from its arena.
inline size_t compressBytes(int rows, int columns, const PcaSettings &s) {
    return ((size_t)s.clusters * ((size_t)(1 + s.dimensions) * (size_t)columns + 1) +
            (size_t)rows * (size_t)(s.dimensions + 1)) *
               sizeof(float) +
           4096;
}

// Compresses the rows. The caller sets p.data, p.rows and p.columns, and in `p.cluster` the cluster that each
// row starts in (0 .. settings.clusters - 1); compress() changes `p.cluster`. False when the arena is full.
bool compress(ClusteredPca &p, const PcaSettings &settings, Arena &arena, Workers &workers);

} // namespace odraz::radiosity
