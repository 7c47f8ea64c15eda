// References for a solved mesh: light at random points by path tracing, without elements, charts or rows.
#pragma once

#include "tools/radiosity/read/mesh.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

struct MeshProbe {
    int chart;
    Vec3 p, n;
    Rgb solved;    // light of the solution: irradiance / pi
    Rgb traced;    // light of the paths
    Rgb lamps;     // the part of `traced` that comes from suns, balls and emitting triangles, not reflected
    Rgb reflected; // the part that surfaces have reflected; the rest is light of the sky
    double noise2; // an unbiased estimate of the variance of `traced`'s brightness
    double reflectedNoise2; // the same of `reflected`
    float size;             // width plus height of the chart
};

// Random points, spread by area over the surfaces of a solution that reflect.
std::vector<MeshProbe> placeMeshProbes(const Solution &solution, int count);

// Sets `solved` from another solution of the model.
void solvedAt(const Solution &solution, std::vector<MeshProbe> &probes);

// Traces two sets of side x side paths from every probe. Directions are cosine-distributed, the first ones
// stratified; shadow rays sample the lamps; Russian roulette ends the paths. Drops the probes inside closed
// bodies. Balls emit and block nothing, as in solutions. Once `stop` is nonzero, remaining probes stay black.
void tracePaths(const Mesh &mesh, const Surroundings &surroundings, std::vector<MeshProbe> &probes, int side,
                Workers &workers, const int *stop = nullptr);

// Errors of luminance, in percent. rms and noise are shares of the root mean square of the reference's light;
// the paths' noise is subtracted from rms in quadrature. median and worst20 (the 95 % quantile) are relative
// errors at points with 1/1000 of the mean light or more. NaN: not defined. Without light, the first three
// are 0.
struct MeshErrors {
    double median, worst20, rms, bias, noise;
};
MeshErrors errorsOf(const std::vector<MeshProbe> &probes);
// The errors of luminances, one for each point. `noise2`: the sum of the reference's variances.
MeshErrors errorsOf(const std::vector<float> &values, const std::vector<float> &reference, double noise2 = 0);

} // namespace odraz::radiosity
