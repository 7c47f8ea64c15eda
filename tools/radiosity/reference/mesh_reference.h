// References for a solved mesh: light at some places by path tracing, which uses no elements, charts or rows.
#pragma once

#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

struct MeshProbe {
    int chart;
    Vec3 p, n;
    Rgb solved;    // light by the solution: irradiance / pi
    Rgb traced;    // light by the paths
    double noise2; // an unbiased estimate of the variance of `traced`'s brightness
    float size;    // the chart's: the sum of its sides
};

// Places spread at random by area over the lit surfaces of a solution.
std::vector<MeshProbe> placeMeshProbes(const Solution &solution, int count);

// Sets `solved` from another solution of the model.
void solvedAt(const Solution &solution, std::vector<MeshProbe> &probes);

// Traces two sets of side x side paths from every probe. Directions are cosine-distributed, the first ones
// stratified; shadow rays sample the lamps; Russian roulette ends the paths. Drops the probes that lie inside
// closed bodies. Balls emit and block nothing, as in solutions. If `stop` becomes other than 0, the remaining
// probes stay black.
void tracePaths(const Mesh &mesh, const Surroundings &around, std::vector<MeshProbe> &probes, int side,
                Workers &workers, const int *stop = nullptr);

// Errors of luminance, in percent. rms and noise are shares of the root mean square of the reference's light;
// the noise of the paths is subtracted in quadrature. Median and worst20 are relative, over places with at
// least a thousandth of the mean light. NaN if there are none; without any light the first three are 0.
struct MeshErrors {
    double median, worst20, rms, bias, noise;
};
MeshErrors errorsOf(const std::vector<MeshProbe> &probes);
// The same of luminances, one for each place; `noise2`: the sum of the variances of the reference's.
MeshErrors errorsOf(const std::vector<float> &values, const std::vector<float> &reference, double noise2 = 0);

} // namespace odraz::radiosity
