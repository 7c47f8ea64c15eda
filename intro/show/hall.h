// The hall of scenes 4 to 6: a nave between two rows of columns under beams, high windows on one side, a
// stair, three lanterns, and a door of light: eight upright strips in the far wall. Metres; x across, -z away
// from the entrance.
#pragma once

#include "transfer/glossy.h"

namespace odraz {

inline constexpr int kLanterns = 3, kStrips = 8;
inline constexpr int kHours = 8; // of the day, from dawn to dusk and night
inline constexpr int kSuns = 28; // positions whose bounces are solved, four for each hour
inline constexpr int kFirstLantern = kSh + kSuns, kFirstStrip = kFirstLantern + kLanterns; // of the bases
inline constexpr int kBounces = 4; // kept one by one, for scene 4
inline constexpr int kNoon = 3;    // the hour that scene 4 shows
inline constexpr int kSeen = 64;   // pixels of the hemicube that it shows

struct Hall {
    Model model;
    Radiosity radiosity;
    Glossy floor;
    float *light[3];  // planes of texels, blended for the picture at hand
    float *mosaic[3]; // colours of patches, where scene 4 shows them
    Lightmap map;
    // Irradiance / pi of every patch after so many bounces of the light of kNoon; [0] is direct light
    Rgb *bounce[kBounces + 1];
    // The patch that scene 4 visits, and what it sees: a hemicube, 3 kSeen rows of kSeen as hemicube.h lays
    // them out, finer than those that the hall is solved with
    int visited;
    uint32_t *seen;
    Rgb mean[kMaxMaterials]; // each material's reflectance
};

// How the hall is lit.
struct HallLight {
    float hour;                // 0 .. kHours - 1
    float lanterns[kLanterns]; // 0 .. 1
    float strips[kStrips];
    float sun; // how much of the sun the tracer draws: 1, or less where the lightmap has its direct light
};

size_t hallBytes();
// As it ships: see `tradeoff radiosity`.
inline constexpr RadiositySettings kHallSettings = {.px = 16,
                                                    .block = 1,
                                                    .levels = 1,
                                                    .contrast = 0.3f,
                                                    .traced = ((1ull << (kSuns + kLanterns)) - 1) << kSh,
                                                    .residual = 1e-2f};
// The sky of an hour, and its sun.
struct Daylight {
    Sky sky;
    Vec3 sunAt;   // world
    Rgb sunlight; // irradiance / pi on what faces it
};
Daylight daylightAt(float hour);

// What there is of each basis. `drawn`: which shares of the lanterns' own light the tracer draws; null: none.
LightVector lightVector(const HallLight &light, const float *drawn = nullptr);

// Builds it and fills a scene with it, for solveRadiosity().
void prepareHall(Hall &hall, Scene &scene);
// Finds the gloss of the floor, once the hall is solved.
bool polish(Hall &hall, const GlossySettings &settings, Arena &arena, Workers &workers);
// Builds and solves it, using `scene` for the while. Null, or a line that says what is missing and what to
// do.
const char *loadHall(Hall &hall, Scene &scene, const Gl &gl, Arena &arena, Workers &workers,
                     const Progress &progress);

// Fills a scene with the hall and its lights: the sun and the two strongest lanterns are left to the tracer.
// `grey` 1 .. 0 has all surfaces alike or in their own materials.
void poseHall(Hall &hall, const HallLight &light, float grey, Scene &scene);

} // namespace odraz
