// A polished material, by the film's method (transfer/glossy.h): a matrix for each square of its charts.
//
// The matrix maps light to the 25 coefficients of the radiance that arrives from the upper half-space, after
// all bounces. Their product with the coefficients of a lobe around the mirrored direction is the radiance
// towards the eye. Clustered PCA compresses the matrices. Light that the polished surface mirrors onto other
// surfaces is lost.
#pragma once

#include "base/parallel.h"
#include "transfer/glossy.h"

#include <functional>
#include <vector>

namespace odraz::radiosity {

struct Solution;

struct GlossyChart {
    int chart = 0, bases = 0, across = 0, down = 0; // across, down: number of squares along u and v
    int clusters = 0, dimensions = 0;               // these and the arrays: as in ClusteredPca
    std::vector<int> members, first;
    std::vector<float> axes, weights;
};

inline constexpr int kMostGlossyCharts = 64, kMostSquares = 4096;

// Default reflectance of the polish as seen from above; reflectance rises to 1 at grazing angles (Schlick).
inline constexpr float kPolish = 0.06f;

// Writes to `to`, which is zero before, the radiance that arrives at `from` from the unit direction d: RGB of
// each basis.
using Arrives = std::function<void(const Vec3 &from, const Vec3 &d, float *to)>;

// Divides a chart into squares about `side` wide.
GlossyChart squaresOf(const Chart &chart, int number, int bases, float side);

// Finds the matrices with `rays` rays from the middle of each square, and compresses them.
void findGloss(GlossyChart &gloss, const Chart &chart, int rays, float exponent, const Arrives &arrives,
               Workers &workers);

// Sets model.gloss to the radiance that the charts send to an eye under a light.
void showGloss(const std::vector<GlossyChart> &gloss, Solution &model, const LightVector &light,
               const Vec3 &eye, float polish);

} // namespace odraz::radiosity
