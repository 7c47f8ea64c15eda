// The light of one moment in a room: by the film's sum of rows (transfer/relight.h), or from its clusters.
#pragma once

#include "tools/radiosity/transfer/transfer_room.h"
#include "transfer/relight.h"

#include <memory>

namespace odraz::radiosity {

// How strong everything is, and how it is summed up.
struct Lighting {
    BandLight sky = {};       // turned already
    std::vector<float> lamps; // of each lamp: 1 is its full strength
    int bands = kMostBands;   // bands of the sky in use
    int rank = -1;            // axes of each cluster in use; -1: the exact rows
};

// The sky's light turned by `turn` degrees about the axis that points up, from -z (+y where z is up) towards
// +x; then tilted about x, the middle of the picture upwards.
BandLight turnedSky(const BandLight &sky, const TransferRoom &room, double turn, double tilt);

// The weight of each of the room's bases.
LightVector lightVector(const TransferRoom &room, const Lighting &lighting);

// Sums up rooms, in memory of its own. The room must outlive it.
class Relighter {
public:
    explicit Relighter(const TransferRoom &room);
    // Irradiance / pi of each texel; may be below 0 where the bands are too few for a light. `clusters`: the
    // room's own, or others of it.
    void relight(const Clusters &clusters, const Lighting &lighting, std::vector<Rgb> &light);
    void relight(const Lighting &lighting, std::vector<Rgb> &light) {
        relight(room.clusters, lighting, light);
    }
    // Sets the light, emission and gloss of a copy of the room's model. Light below 0 becomes 0. With `eye`,
    // gloss towards it is added.
    void show(const Clusters &clusters, const Lighting &lighting, const Vec3 *eye, Solution &model);

private:
    const TransferRoom &room;
    std::unique_ptr<Model> model; // of it, only the number of texels is used
    Radiosity radiosity = {};
    std::vector<float> sums[3];
};

// The room as a solution for this light, which `render` and `export` take; `eye` as above.
Solution litModel(const TransferRoom &room, const Lighting &lighting, const Vec3 *eye);

// Sets the emission of the model's charts, from the lamps' strengths.
void lightLamps(const TransferRoom &room, const Lighting &lighting, Solution &model);

} // namespace odraz::radiosity
