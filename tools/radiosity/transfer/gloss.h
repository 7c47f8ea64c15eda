// A polished material, by the film's method (transfer/glossy.h): a matrix for each square of its charts.
//
// The matrix maps light to the 25 coefficients of the radiance that arrives from the upper half-space, after
// all bounces. Their product with the coefficients of a lobe around the mirrored direction is the radiance
// towards the eye. Clustered PCA compresses the matrices, one row for each square. Light that the polished
// surface mirrors onto other surfaces is lost.
#pragma once

#include "tools/radiosity/transfer/clusters.h"
#include "transfer/glossy.h"

#include <functional>

namespace odraz::radiosity {

struct GlossyChart {
    int chart = 0, across = 0, down = 0; // across, down: number of squares along u and v
    Clusters clusters;                   // a square's matrix: [bases][kGlossOutputs]
};

inline constexpr int kMostGlossyCharts = 64, kMostSquares = 4096;

// Default reflectance of the polish as seen from above; reflectance rises to 1 at grazing angles (Schlick).
inline constexpr float kPolish = 0.06f;

// Writes to `to`, which is zero before, the radiance that arrives at `from` from the unit direction d: RGB of
// each basis.
using Arrives = std::function<void(const Vec3 &from, const Vec3 &d, float *to)>;

// Divides chart `number` into squares about `side` wide, finds their matrices with `rays` rays from the
// middle of each, and compresses them.
GlossyChart findGloss(const Chart &chart, int number, int bases, float side, int rays, float exponent,
                      const Arrives &arrives, Workers &workers);

// Sets model.gloss to the radiance that the charts send to an eye under a light.
void showGloss(const std::vector<GlossyChart> &gloss, Solution &model, const LightVector &light,
               const Vec3 &eye, float polish);

} // namespace odraz::radiosity
