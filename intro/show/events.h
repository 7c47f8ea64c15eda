// The film's events and their rows: one table for scenes, score and tests.
//
// Rows count from the start of the scene's story, like its camera keys (8 a second, 16 a bar), so events move
// with their scene. An event marked as heard has a sound in music.h, which begins on its row.
#pragma once

#include "base/rows.h"
#include "show/event.h"

namespace odraz {

enum SceneId : uint8_t { kPoint, kTable, kFlake, kPatches, kHall, kOdraz, kCredits, kSceneCount };

// clang-format off
enum EventId : uint8_t {
    kLightIsBorn, kLightGrows, kRimLightWakes, kCausticFalls, kWordComes, kWordStands,
    kBallsSetOff,
    kGeneration1, kGeneration2, kGeneration3,
    kHallIsBlack, kPatchIsVisited, kHemicubeRises, kHemicubeOpens, kPatchTakesColour, kHemicubeCloses,
    kDirectLight, kBounce1, kBounce2, kBounce3, kPatchesMelt,
    kLamp1, kLamp2, kLamp3, kLamp3Dies, kLamp2Dies, kLamp1Dies, kLightReturns,
    kStrip1, kStrip2, kStrip3, kStrip4, kStrip5, kStrip6, kStrip7, kStrip8,
    kLampLights, kBall1, kBall2, kBall3, kBall4, kBall5, kDoorDies,
    kBall5Leaves, kOuterLampsDie, kBall4Leaves, kBall3Leaves, kBall1Leaves, kWordIsFound, kWordShines,
    kLine1, kLine2, kLine3,
    kEventCount
};

inline constexpr Event kEvents[] = {
    {kLightIsBorn,      kPoint,     0, true},
    {kLightGrows,       kPoint,    16, true},
    {kRimLightWakes,    kPoint,    48, true},
    {kCausticFalls,     kPoint,    64, true},
    {kWordComes,        kPoint,    80, true}, // then a stroke on every beat
    {kWordStands,       kPoint,   112, true},

    {kBallsSetOff,      kTable,    16, true}, // one ball each beat

    {kGeneration1,      kFlake,    16, true},
    {kGeneration2,      kFlake,    32, true},
    {kGeneration3,      kFlake,    48, true},

    {kHallIsBlack,      kPatches,   0, true},
    {kPatchIsVisited,   kPatches,  16, true},
    {kHemicubeRises,    kPatches,  32, true},
    {kHemicubeOpens,    kPatches,  48, true},
    {kPatchTakesColour, kPatches,  64, true},
    {kHemicubeCloses,   kPatches,  72, true},
    {kDirectLight,      kPatches,  80, true}, // then a bounce each bar
    {kBounce1,          kPatches,  96, true},
    {kBounce2,          kPatches, 112, true},
    {kBounce3,          kPatches, 128, true},
    {kPatchesMelt,      kPatches, 144, false},

    {kLamp1,            kHall,   152, true},
    {kLamp2,            kHall,   156, true},
    {kLamp3,            kHall,   160, true},
    {kLamp3Dies,        kHall,   172, true},
    {kLamp2Dies,        kHall,   176, true},
    {kLamp1Dies,        kHall,   180, true},
    {kLightReturns,     kHall,   196, true},
    {kStrip1,           kHall,   224, true}, // the light enters the door
    {kStrip2,           kHall,   228, true},
    {kStrip3,           kHall,   232, true},
    {kStrip4,           kHall,   236, true},
    {kStrip5,           kHall,   240, true},
    {kStrip6,           kHall,   244, true},
    {kStrip7,           kHall,   248, true},
    {kStrip8,           kHall,   252, true},

    {kLampLights,       kOdraz,    64, true},
    {kBall1,            kOdraz,     0, true},
    {kBall2,            kOdraz,     4, true},
    {kBall3,            kOdraz,     8, true},
    {kBall4,            kOdraz,    12, true},
    {kBall5,            kOdraz,    16, true},
    {kDoorDies,         kOdraz,   128, true},
    {kBall5Leaves,      kOdraz,    84, true},
    {kOuterLampsDie,    kOdraz,   132, true},
    {kBall4Leaves,      kOdraz,    88, true},
    {kBall3Leaves,      kOdraz,    96, true},
    {kBall1Leaves,      kOdraz,   116, true},
    {kWordIsFound,      kOdraz,   144, false}, // mirrored in the last ball; the word is behind the camera
    {kWordShines,       kOdraz,   160, true},

    {kLine1,            kCredits,   4, true},
    {kLine2,            kCredits,  28, true},
    {kLine3,            kCredits,  48, false},
};
// clang-format on
static_assert(inOrder(kEvents, &Event::id, kEventCount), "a row for every event, in the enum's order");

// Returns the row of an event, for keys.
consteval float rowOf(EventId event) { return kEvents[event].row; }

// The events of the big hits. The half beat before each is silent.
inline constexpr EventId kHits[] = {kHallIsBlack, kDirectLight, kStrip1, kBall1};

} // namespace odraz
