// How far a room's light is from solutions made for that very light: what `transfer --check` prints.
#pragma once

#include "tools/engine/machine.h"
#include "tools/radiosity/transfer/find_transfer.h"
#include "tools/radiosity/transfer/relight.h"

#include <string>

namespace odraz::radiosity {

// A light to try: its bands, as a room is relit with, and the same as a picture or as given, to be solved
// for.
struct TriedSky {
    std::string name;
    BandLight light;
    SkyPicture sky;
    std::vector<Sun> suns;
};

// Environments that this number of bands holds entirely: an even one, a gradient, a glow near the horizon,
// two lights and random coefficients.
std::vector<TriedSky> bandLimitedSkies(int bands, bool upIsZ);
// A band-limited light as a picture, fine enough that reading it changes little (1e-4).
SkyPicture pictureOf(const BandLight &light, int bands, bool upIsZ);

// A solution for a sky alone, its lamps dark: from rays like the room's own, or with rays == 0 from others,
// as many as this light needs. A value other than 0 in `stop` ends it early; then the light is useless.
std::vector<Rgb> freshLight(const Mesh &mesh, const TransferSettings &settings, int rays, const TriedSky &sky,
                            Workers &workers, const int *stop = &kNever);
// A solution for the model's lamps alone.
std::vector<Rgb> freshLamps(const Mesh &mesh, const TransferSettings &settings, int rays, Workers &workers,
                            const int *stop = &kNever);

// Root mean square of a - b as a share of b's.
double difference(const std::vector<Rgb> &a, const std::vector<Rgb> &b);

// One subspace for all rows of a room, of the fewest axes that take as much memory as `floats`; without axes
// where that is more than kMostRank.
Clusters oneSubspace(const TransferRoom &room, const std::vector<float> &rows,
                     const std::vector<float> &scale, size_t floats, Workers &workers);

// Prints tables: errors by rows and by clusters under band-limited skies and those given, what the bands lose
// of the latter, and one subspace (PCA) against clusters (CPCA) at equal memory. Returns false as soon as
// there is a value other than 0 in `stop`.
bool printCheck(const Mesh &mesh, const TransferSettings &settings, const TransferRoom &room, int rays,
                const std::vector<std::string> &skies, Workers &workers, const int *stop);

} // namespace odraz::radiosity
