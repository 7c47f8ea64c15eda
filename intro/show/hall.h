// The hall of scenes 4 to 6: a nave between two rows of columns under beams, with high windows on one side, a
// stair, three lanterns, and a door of light, which is eight upright strips in the far wall. Units are
// metres; x points across the hall, -z away from the entrance.
#pragma once

#include "show/daylight.h"
#include "transfer/room.h"

namespace odraz {

inline constexpr int kLanterns = 3, kStrips = 8;
inline constexpr int kHallMaterials = 9 + kLanterns + kStrips; // the number of materials that poseHall() adds
inline constexpr int kSuns = 28;                               // solved positions of the sun, four an hour
// The skies are spherical harmonics; the lamps are the lanterns, then the strips
inline constexpr BasisOrder kHallBases = {kSh, kSuns, kLanterns + kStrips};
static_assert(kHallBases.withinLimits());
inline constexpr int kFirstSun = kHallBases.firstSun(), kFirstLantern = kHallBases.firstLamp(),
                     kFirstStrip = kFirstLantern + kLanterns;

struct Hall : Room {
    int floor, vault; // charts of the floor and of the ceiling's middle bay
};

// The light in the hall.
struct HallLight {
    float hour;                // 0 .. kHours - 1
    float lanterns[kLanterns]; // 0 .. 1
    float strips[kStrips];
    float sun;        // share of the sun that the tracer draws; the lightmap has the rest of its direct light
    float door = 0;   // 1: the tracer draws the strips' light as one lamp, and nothing outside the hall
    Light extra = {}; // added by the scene: traced, and bounced like the light of the nearest lanterns
};

// Returns the strength of each basis. `drawn`: the shares of the lanterns' direct light that the tracer
// draws; null: none.
LightVector lightVector(const HallLight &light, const float *drawn = nullptr);

// Builds the hall's model and lights, and makes a finished scene of it, for solveRoom().
void prepareHall(Hall &hall, Scene &scene);

// The settings of the film. Against path tracing, smaller patches in the openings of the windows
// (hall_model.cpp) pay more than finer hemicubes or a smaller residual (tools/measure/RESULTS.md, "The hall's
// light").
inline constexpr RadiositySettings kHallSettings = {.px = 16, .block = 2, .residual = 3e-2f};
inline constexpr float kGlossExponent = 16; // exponent of the floor's gloss (see window())
// Returns the settings for solveRoom() and a prepared hall: kHallSettings, the lobe of its gloss, the light
// that scene 4 shows, and the position of the patch that it visits.
RoomSettings hallSettings(const Hall &hall);

// Fills a scene with the hall and its lights, lit for an eye. The tracer draws the sun and the two strongest
// lanterns. `grey`: 1 makes all surfaces the same grey, 0 gives them their materials.
void poseHall(Hall &hall, const HallLight &light, float grey, const Vec3 &eye, Scene &scene);

} // namespace odraz
