// A room's light under given lighting: by the film's sum of rows (transfer/relight.h), or from its clusters.
#pragma once

#include "tools/radiosity/transfer/transfer_room.h"
#include "transfer/relight.h"

#include <memory>

namespace odraz::radiosity {

// The strength of sky and lamps, and how to sum their light.
struct Lighting {
    BandLight sky = {};       // already rotated
    std::vector<float> lamps; // of each lamp: 1 is its full strength
    int bands = kMostBands;   // bands of the sky in use
    int rank = -1;            // axes of each cluster in use; -1: the exact rows
};

// The sky's light rotated by `turn` degrees about the axis that points up, from -z (+y if z is up) towards
// +x; then by `tilt` about x, the middle of the picture upwards.
BandLight turnedSky(const BandLight &sky, const TransferRoom &room, double turn, double tilt);

// The weight of each of the room's bases.
LightVector lightVector(const TransferRoom &room, const Lighting &lighting);

// Sums the light of a room, which must outlive it.
class Relighter {
public:
    explicit Relighter(const TransferRoom &room);
    // Irradiance / pi of each texel; it may be below 0 if the light needs more bands. `clusters`: the room's,
    // or others found for it.
    void relight(const Clusters &clusters, const Lighting &lighting, std::vector<Rgb> &light);
    void relight(const Lighting &lighting, std::vector<Rgb> &light) {
        relight(room.clusters, lighting, light);
    }
    // Sets the light, emission and gloss of a copy of the room's model. Light below 0 becomes 0. `eye` may be
    // null: then there is no gloss.
    void show(const Clusters &clusters, const Lighting &lighting, const Vec3 *eye, Solution &model);

private:
    const TransferRoom &room;
    std::unique_ptr<Model> model; // only its number of texels is used
    Radiosity radiosity = {};
    std::vector<float> sums[3];
};

// The room as a solution under this light, for `render` and `export`; `eye` as above.
Solution litModel(const TransferRoom &room, const Lighting &lighting, const Vec3 *eye);

} // namespace odraz::radiosity
