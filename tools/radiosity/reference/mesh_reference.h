// References for a solved mesh: light at some of its places by path tracing, which knows nothing of elements,
// charts or rows.
#pragma once

#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

struct MeshProbe {
    int chart;
    Vec3 p, n;
    Rgb solved;    // what arrives by the solution: irradiance / pi
    Rgb traced;    // the same by the paths
    double noise2; // an estimate of the variance of the traced mean's brightness, without bias
};

// Places spread at random by area over the lit surfaces of a solution. With `middles`, the middles of the
// elements at such places, with the element's mean light, as the CSV has them.
std::vector<MeshProbe> placeMeshProbes(const Solution &solution, int count, bool middles = false);

// Finds the light of the same places in another solution of the model.
void solvedAt(const Solution &solution, std::vector<MeshProbe> &probes);

// Traces two sets of side x side paths from every probe. Directions are cosine-distributed, the first ones
// stratified; shadow rays sample the lamps; Russian roulette ends the paths. Drops the probes that lie inside
// closed bodies. Balls shine and block nothing, as in solutions. Where `stop` becomes other than 0, the
// probes that are left stay black.
void tracePaths(const Mesh &mesh, const Surroundings &around, std::vector<MeshProbe> &probes, int side,
                Workers &workers, const int *stop = nullptr);

// Errors in percent; the rms is without the noise of the paths, which is subtracted in quadrature. Median and
// worst20 are relative, and of places that are not dark: that have a thousandth of the mean light at least.
// Not numbers where all are dark.
struct MeshErrors {
    double median, worst20, rms, bias, noise;
};
MeshErrors errorsOf(const std::vector<MeshProbe> &probes);

} // namespace odraz::radiosity
