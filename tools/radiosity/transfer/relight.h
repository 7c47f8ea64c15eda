// Computes a room's light under given lighting, by its rows as in the film, or by its clusters.
#pragma once

#include "tools/radiosity/transfer/transfer_room.h"
#include "transfer/relight.h"

#include <memory>

namespace odraz::radiosity {

// The strength of sky and lamps, and how their light is summed.
struct Lighting {
    BandLight sky = {};       // already rotated
    std::vector<float> lamps; // strength of each lamp; 1: its full strength
    int bands = kMostBands;   // number of the sky's bands in use
    int rank = -1;            // number of each cluster's axes in use; -1: the exact rows
};

// The sky's light, rotated by `turn` degrees about the axis that points up, from -z (+y if z is up) towards
// +x, then by `tilt` degrees about x, which moves the middle of the picture upwards.
BandLight turnedSky(const BandLight &sky, const TransferRoom &room, double turn, double tilt);

// Sums the light of a room. The room must outlive the Relighter.
class Relighter {
public:
    explicit Relighter(const TransferRoom &room);
    // Writes irradiance / pi of each texel, which may be below 0 if the light needs more bands. `clusters`:
    // the room's clusters, or others found for it.
    void relight(const Clusters &clusters, const Lighting &lighting, std::vector<Rgb> &light);
    void relight(const Lighting &lighting, std::vector<Rgb> &light) {
        relight(room.clusters, lighting, light);
    }
    // Sets light (at least 0), emission and gloss of a copy of the room's model. `eye` null: without gloss.
    void show(const Clusters &clusters, const Lighting &lighting, const Vec3 *eye, Solution &model);

private:
    const TransferRoom &room;
    std::unique_ptr<Model> model; // only its number of texels is used
    Radiosity radiosity = {};
    std::vector<float> sums[3];
};

// The room as a solution under this light, for `render` and `export`. `eye`: as above.
Solution litModel(const TransferRoom &room, const Lighting &lighting, const Vec3 *eye);

} // namespace odraz::radiosity
