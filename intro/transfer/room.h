// A room: a model that is solved once for all its lights and relit for every picture, with bounces and gloss.
//
//   start-up: patches -> hemicubes -> form factors -> solution for every light basis -> gloss, bounces
//   a picture: strength of every basis -> light on every texel -> lightmap of the tracer
#pragma once

#include "transfer/glossy.h"

namespace odraz {

inline constexpr int kBounces = 4; // the number of bounces that are stored
// Width in pixels of the stored hemicube, which is finer than those for solving.
inline constexpr int kSeen = 160;

struct RoomSettings {
    RadiositySettings radiosity;
    float exponent;       // exponent of the gloss's lobe (see window())
    int polished;         // the chart that has gloss
    LightVector followed; // the light whose bounces are stored; only `bounced` counts
    Vec3 visited;         // a point; the hemicube of the patch nearest to it is stored
};

struct Room {
    Glossy gloss;
    Lightmap map;            // for the tracer: points to the planes below and to the gloss
    float *light[3];         // planes of texels for this picture: irradiance / pi
    float *mosaic[3];        // colours of patches, for pictures that show patches
    Rgb mean[kMaxMaterials]; // each material's reflectance
    // Irradiance / pi on every patch after each bounce of the followed light; [0] is direct light
    Rgb *bounce[kBounces + 1];
    // The visited patch and its hemicube: 3 kSeen rows of kSeen pixels in the layout of hemicube.h, and an
    // empty row
    int visited;
    uint32_t *seen;
    Radiosity radiosity;
    Model model;

    bool solved() const { return map.charts; }
};

// Size of the arena for solving: enough for a room of 29,000 texels, 6,000 patches and 64 bases, with a
// quarter to spare.
inline constexpr size_t kRoomBytes = (size_t)192 << 20;

// Solves room.model, lit by room.radiosity.bases. The scene must contain the posed, finished model; solving
// traces rays in it. Returns null, or an error line. Gives back the memory that only solving needs.
const char *solveRoom(Room &room, Scene &scene, const RoomSettings &settings, const SolverHost &host);

// Adds the model to a scene, with the room's light. The charts use the scene's materials.
inline void poseRoom(Room &room, Scene &scene) {
    room.model.pose(scene);
    scene.lightmap = &room.map;
    room.map.mosaic = 0;
}

// Updates the light on the texels, and the gloss for an eye. `reflect` and `strength`: see relightGlossy().
inline void relightRoom(Room &room, const LightVector &light, const Vec3 &eye, float reflect,
                        float strength) {
    relight(room.radiosity, room.model, light, room.light);
    relightGlossy(room.gloss, light, eye, reflect, strength);
}

// Returns the mean light on the texels of a chart.
Rgb meanLight(const Room &room, int chart);

} // namespace odraz
