// A room: a model that is solved once, for all its lights, and relit in every picture, bounces and gloss
// included.
//
//   start-up: patches -> hemicubes (GL) -> form factors -> solution for every light basis -> gloss, bounces
//   a picture: how much there is of every basis -> light on every texel -> what the tracer reads
#pragma once

#include "transfer/glossy.h"

namespace odraz {

inline constexpr int kBounces = 4; // kept one by one
inline constexpr int kSeen = 64;   // pixels of the hemicube that is kept, finer than those that solve

struct RoomSettings {
    RadiositySettings radiosity;
    GlossySettings gloss;
    int polished;                // the chart that has gloss
    float importance[kMaxBases]; // how much there may be of each basis: gloss is kept in that measure
    LightVector followed;        // the light whose bounces are kept; tells of them by `bounced` alone
    Vec3 visited;                // the patch nearest to it is the one whose hemicube is kept
};

struct Room {
    Glossy gloss;
    Lightmap map;            // what the tracer reads: the planes below and those of gloss
    float *light[3];         // planes of texels, of the picture at hand: irradiance / pi
    float *mosaic[3];        // colours of patches, where a picture shows them instead
    Rgb mean[kMaxMaterials]; // each material's reflectance
    // Irradiance / pi on every patch after so many bounces of the followed light; [0] is direct light
    Rgb *bounce[kBounces + 1];
    // The visited patch and what it sees: a hemicube, 3 kSeen rows of kSeen as hemicube.h lays them out
    int visited;
    uint32_t *seen;
    Radiosity radiosity;
    Model model;
};

// Arena that solving takes: for a room of 12,000 texels, 3,500 patches and 64 bases, with a tenth to spare.
inline constexpr size_t kRoomBytes = (size_t)224 << 20;

// Solves room.model, lit by room.radiosity.lights. The scene holds the model, posed and finished, and is used
// for the while. Returns null, or a line that says what is missing and what to do.
const char *solveRoom(Room &room, Scene &scene, const RoomSettings &settings, const Gl &gl, Arena &arena,
                      Workers &workers, const Progress &progress);

// Adds the model to a scene, with the room's light on it. The materials of its charts are the scene's.
inline void poseRoom(Room &room, Scene &scene) {
    room.model.pose(scene);
    scene.lightmap = &room.map;
    room.map.mosaic = 0;
}

// Lights it: texels, and gloss for an eye; `reflect` and `strength` as relightGlossy() has them.
inline void relightRoom(Room &room, const LightVector &light, const Vec3 &eye, float reflect,
                        float strength) {
    relight(room.radiosity, room.model, light, room.light);
    relightGlossy(room.gloss, light, eye, reflect, strength);
}

// The average over the texels of a chart.
Rgb meanLight(const Room &room, int chart);

} // namespace odraz
