// The difference between a relit room and solutions made for the same light: `transfer --check`.
#pragma once

#include "tools/engine/machine.h"
#include "tools/radiosity/transfer/find_transfer.h"
#include "tools/radiosity/transfer/relight.h"

#include <string>

namespace odraz::radiosity {

// A light for the check: its bands, for relighting, and the same light as a picture and suns, for a solution.
struct TriedSky {
    std::string name;
    BandLight light;
    SkyPicture sky;
    std::vector<Sun> suns;
};

// Environments that this number of bands represents exactly: an even one, a gradient, a glow near the
// horizon, two lights and random coefficients.
std::vector<TriedSky> bandLimitedSkies(int bands, bool upIsZ);
// A band-limited light as a picture, with pixels small enough for an error of 1e-4.
SkyPicture pictureOf(const BandLight &light, int bands, bool upIsZ);

// The root mean square of a - b, as a share of that of b.
double difference(const std::vector<Rgb> &a, const std::vector<Rgb> &b);

// Prints tables: errors by rows and by clusters under band-limited skies and under `skies`, the energy that
// the bands lose of the latter, and one subspace (PCA) against clusters (CPCA) at equal memory. Returns false
// as soon as `stop` is not 0.
bool printCheck(const Mesh &mesh, const TransferSettings &settings, const TransferRoom &room, int rays,
                const std::vector<std::string> &skies, Workers &workers, const int *stop);

} // namespace odraz::radiosity
