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
    kGlint, kBallsSetOff, kMacro, kCopperFills, kDarkBall, kSwallowed,
    kBareBall, kGeneration1, kGeneration2, kGeneration3, kGateOpens, kFlakeGoes,
    kHallIsBlack, kLinesSpread, kHemicubeRises, kHemicubeOpens, kPatchTakesColour, kHemicubeCloses,
    kDirectLight, kBounce1, kBounce2, kBounce3, kPatchesMelt, kBallRollsIn,
    kNoonStrikes, kPointIsReborn, kLamp1, kLamp2, kLamp3, kLamp3Dies, kLamp2Dies, kLamp1Dies,
    kLightReturns, kCrown, kStrip1, kStrip2, kStrip3, kStrip4, kStrip5, kStrip6, kStrip7, kStrip8,
    kBallFollows, kStripsPlay, kDoorStops,
    kBall1, kBall2, kBall3, kBall4, kBall5, kToneUp, kLampLights, kRecall, kSummit, kDoorDies,
    kBallsLeave, kWordIsFound, kWordShines,
    kLine1, kLine2, kLine3, kWordGoes, kPointGoesOut, kEchoesGo, kLastAnswer,
    kEventCount
};

inline constexpr Event kEvents[] = {
    {kLightIsBorn,      kPoint,      0, true},
    {kLightGrows,       kPoint,     16, true},
    {kRimLightWakes,    kPoint,     40, true},
    {kCausticFalls,     kPoint,     48, true},
    {kWordComes,        kPoint,     60, false}, // then a stroke on every beat
    {kWordStands,       kPoint,     92, false},

    {kGlint,            kTable,      0, true},
    {kBallsSetOff,      kTable,     16, false}, // one ball each beat
    {kMacro,            kTable,     48, false},
    {kCopperFills,      kTable,     96, true},
    {kDarkBall,         kTable,    112, true},
    {kSwallowed,        kTable,    156, false},

    {kBareBall,         kFlake,      0, true},
    {kGeneration1,      kFlake,     16, true},
    {kGeneration2,      kFlake,     32, true},
    {kGeneration3,      kFlake,     48, true},
    {kGateOpens,        kFlake,    112, true},
    {kFlakeGoes,        kFlake,    188, false},

    {kHallIsBlack,      kPatches,    0, false},
    {kLinesSpread,      kPatches,    8, false},
    {kHemicubeRises,    kPatches,   32, true},
    {kHemicubeOpens,    kPatches,   40, true},
    {kPatchTakesColour, kPatches,   52, true},
    {kHemicubeCloses,   kPatches,   56, true},
    {kDirectLight,      kPatches,   64, true}, // then a bounce each bar
    {kBounce1,          kPatches,   80, true},
    {kBounce2,          kPatches,   96, true},
    {kBounce3,          kPatches,  112, true},
    {kPatchesMelt,      kPatches,  128, true},
    {kBallRollsIn,      kPatches,  176, true},

    {kNoonStrikes,      kHall,      32, true},
    {kPointIsReborn,    kHall,      72, false},
    {kLamp1,            kHall,      96, true},
    {kLamp2,            kHall,     100, true},
    {kLamp3,            kHall,     104, true},
    {kLamp3Dies,        kHall,     116, true},
    {kLamp2Dies,        kHall,     120, true},
    {kLamp1Dies,        kHall,     124, true},
    {kLightReturns,     kHall,     132, false},
    {kCrown,            kHall,     152, true},
    {kStrip1,           kHall,     176, true}, // the light enters the door
    {kStrip2,           kHall,     180, false},
    {kStrip3,           kHall,     184, false},
    {kStrip4,           kHall,     188, false},
    {kStrip5,           kHall,     192, false},
    {kStrip6,           kHall,     196, false},
    {kStrip7,           kHall,     200, false},
    {kStrip8,           kHall,     204, false},
    {kBallFollows,      kHall,     180, false}, // rolls until row 208
    {kStripsPlay,       kHall,     208, true}, // the ball touches the copper strip
    {kDoorStops,        kHall,     236, false}, // one beat of dark

    {kBall1,            kOdraz,      0, true},
    {kBall2,            kOdraz,      4, true},
    {kBall3,            kOdraz,      8, true},
    {kBall4,            kOdraz,     12, true},
    {kBall5,            kOdraz,     16, true},
    {kToneUp,           kOdraz,     64, true}, // all is a tone higher
    {kLampLights,       kOdraz,     96, true},
    {kRecall,           kOdraz,    128, true}, // one beat each: table, flake, patches, day
    {kSummit,           kOdraz,    160, true},
    {kDoorDies,         kOdraz,    192, false}, // the strips go out, one a beat
    {kBallsLeave,       kOdraz,    196, false},
    {kWordIsFound,      kOdraz,    224, false}, // mirrored in the last ball; the word is behind the camera
    {kWordShines,       kOdraz,    256, true},

    {kLine1,            kCredits,    8, true},
    {kLine2,            kCredits,   28, true},
    {kLine3,            kCredits,   48, true},
    {kWordGoes,         kCredits,   64, false}, // a stroke on every beat; their reflections remain
    {kPointGoesOut,     kCredits,   96, false}, // its image in the stone remains
    {kEchoesGo,         kCredits,  100, false}, // the reflections of strokes, one each half beat
    {kLastAnswer,       kCredits,  120, true},
};
// clang-format on
static_assert(inOrder(kEvents, &Event::id, kEventCount), "a row for every event, in the enum's order");

// Returns the row of an event, for keys.
consteval float rowOf(EventId event) { return kEvents[event].row; }

// The events before which all is silent, and for how many rows: two beats after the flake's dead stop, half a
// beat before the direct light and before the first strip, a whole beat before the first ball.
inline constexpr Silence kSilences[] = {
    {kEvents[kLinesSpread], 8}, {kEvents[kDirectLight], 2}, {kEvents[kStrip1], 2}, {kEvents[kBall1], 4}};

} // namespace odraz
