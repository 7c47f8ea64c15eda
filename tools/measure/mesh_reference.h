// What a solved mesh is compared with: light at places of it by path tracing, which knows nothing of
// elements, charts or rows.
#pragma once

#include "tools/radiosity/baked.h"
#include "tools/radiosity/surroundings.h"

namespace odraz {

struct MeshProbe {
    int chart;
    Vec3 p, n;
    Rgb solved;    // what arrives, by the solution: irradiance / pi
    Rgb traced;    // by the paths
    double noise2; // an estimate of the variance of the traced mean's brightness: true in the mean of many
};

// Places spread at random over what is lit of a solution, by area; or the middles of elements that such
// places lie on, with their mean light, as the CSV has them.
std::vector<MeshProbe> placeMeshProbes(const Baked &baked, int count, bool middles = false);

// The same places in another solution of the model.
void solvedAt(const Baked &baked, std::vector<MeshProbe> &probes);

// Traces two sets of side x side paths from every probe: cosine-distributed directions, the first in strata,
// lamps met by shadow rays to points of theirs, until roulette ends them. Drops the probes that lie inside
// something closed.
void tracePaths(const Mesh &mesh, const Surroundings &around, std::vector<MeshProbe> &probes, int side,
                Workers &workers);

// In percent, the paths' own noise taken off in quadrature from rms.
struct MeshErrors {
    double median, worst20, rms, bias, noise;
};
MeshErrors errorsOf(const std::vector<MeshProbe> &probes);

} // namespace odraz
