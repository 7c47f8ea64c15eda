// Compares a relit room with solutions for the same light: `transfer --check`.
#pragma once

#include "tools/radiosity/transfer/find_transfer.h"
#include "tools/radiosity/transfer/relight.h"
#include "tools/support/machine.h"

#include <string>

namespace odraz::radiosity {

// A light for the check: as bands to relight the room, and as a picture and suns to solve the model.
struct TriedSky {
    std::string name;
    BandLight light;
    SkyPicture sky;
    std::vector<Sun> suns;
};

// Environments that `bands` bands represent exactly: even, gradient, glow, two lights, random coefficients.
std::vector<TriedSky> bandLimitedSkies(int bands, bool upIsZ);

// Prints two tables: the errors of rows and clusters under band-limited skies, all lamps, and `skies` (with
// the energy that the bands lose); and the errors of one subspace (PCA) and of clusters (CPCA) with equal
// memory. `rays`: rays from each site, as for the room. Returns false as soon as `stop` is not 0.
bool printCheck(const Mesh &mesh, const TransferSettings &settings, const TransferRoom &room, int rays,
                const std::vector<std::string> &skies, Workers &workers, const int *stop);

} // namespace odraz::radiosity
