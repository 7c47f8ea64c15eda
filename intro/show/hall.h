// The hall of scenes 4 to 6: a nave between two rows of columns under beams, high windows on one side, a
// stair, three lanterns, and a door of light: eight upright strips in the far wall. Metres; x across, -z away
// from the entrance.
#pragma once

#include "show/daylight.h"
#include "transfer/room.h"

namespace odraz {

inline constexpr int kLanterns = 3, kStrips = 8;
inline constexpr int kHallMaterials = 9 + kLanterns + kStrips; // that it adds to a scene
inline constexpr int kSuns = 28; // positions whose bounces are solved, four for each hour
// Its skies are the spherical harmonics; its lamps are the lanterns, then the strips
inline constexpr BasisOrder kHallBases = {kSh, kSuns, kLanterns + kStrips};
static_assert(kHallBases.fit());
inline constexpr int kFirstSun = kHallBases.firstSun(), kFirstLantern = kHallBases.firstLamp(),
                     kFirstStrip = kFirstLantern + kLanterns;

struct Hall : Room {
    int floor, vault; // charts: the floor; the ceiling's middle bay
};

// How the hall is lit.
struct HallLight {
    float hour;                // 0 .. kHours - 1
    float lanterns[kLanterns]; // 0 .. 1
    float strips[kStrips];
    float sun; // how much of the sun the tracer draws: 1, or less where the lightmap has its direct light
    float door = 0;   // 1: the tracer draws the strips' light, as one lamp, and nothing that stands outside
    Light guest = {}; // one that the scene adds: drawn, and its light bounces as the nearest lanterns' does
};

// How much there is of each basis. `drawn`: the shares of the lanterns' own light that the tracer draws;
// null: none.
LightVector lightVector(const HallLight &light, const float *drawn = nullptr);

// Builds the hall's model and lights, and fills and finishes a scene with it, for solveRoom().
void prepareHall(Hall &hall, Scene &scene);

// The settings that ship, chosen by their error against rays and their time.
inline constexpr RadiositySettings kHallSettings = {.px = 16, .block = 2, .residual = 1e-2f};
// Settings for solveRoom(), for a prepared hall: kHallSettings, the lobe of its gloss, the light that scene 4
// follows and the place of the patch that it visits.
inline constexpr float kGlossExponent = 16;
RoomSettings hallSettings(const Hall &hall);

// Fills a scene with the hall and its lights, lit for an eye: the sun and the two strongest lanterns are left
// to the tracer. `grey`: 1 makes all surfaces the same grey, 0 gives them their own materials.
void poseHall(Hall &hall, const HallLight &light, float grey, const Vec3 &eye, Scene &scene);

} // namespace odraz
