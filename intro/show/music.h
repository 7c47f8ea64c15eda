// The film's music: a tune, chords by the bar, parts that play them, and the sounds of events. score.cpp
// plays it.
#pragma once

#include "show/score.h"
#include "show/tune.h"

namespace odraz {

// clang-format off
// Scenes 4 and 5 share bars 32 to 64; the day has those from kDayBegins on. Its music counts from its end, and from the
// first strip of the door. (A test compares it with the film.)
static constexpr uint8_t kDayBegins = 46, kLightless = kDayBegins - 32, kDay = 64 - kDayBegins,
                         kLight = kEvents[kDirectLight].row / 16, kDoor = kEvents[kStrip1].row / 16;
static consteval uint8_t left(int bars) { return (uint8_t)(kDay - bars); }

constexpr const char *const kChords[] = {
    [kPoint] = "DDDDDGAD",
    [kTable] = "DFBADGADDGAB",
    [kFlake] = "GCDGBBFFGGAA",
    [kPatches] = "DDDDDDBFCADADA",
    [kHall] = &"DCDDBFGCBGCADFBADGAA"[20 - kDay],
    [kOdraz] = "DFBADGADBGDA",
    [kCredits] = "dddddd",
};

// Scene, bars from and to; instrument, octave, tones at once, room, how far left; strokes in rows; velocity at
// the start and at the end; line.
static constexpr Part kParts[] = {
    {kPoint, 0, 5, {kGlassDrop, 5, 1, 100}, 5, 64, 50, 60, "..D.aG"},
    {kPoint, 0, 8, {kWind, 6, 1, 100}, 1, 32, 8, 16, "0"},
    {kPoint, 5, 7, {kGlassDrop, 5, 1, 100}, 4, 16, 35, 60, "02140325"},
    {kPoint, 5, 7, {kBrush, 7, 1, 100}, 4, 16, 15, 30, "a"},
    {kPoint, 5, 8, {kPad, 3, 4, 100}, 1, 16, 30, 80, "0"},
    {kPoint, 6, 8, {kRiser, 6, 1, 100}, 1, 32, 20, 20, "a"},

    {kTable, 0, 1, {kDrum, 1, 1, 150}, 1, 16, 80, 80, "a"},
    {kTable, 0, 1, {kImpact, 2, 1, 150}, 1, 16, 40, 40, "D"},
    {kTable, 0, 12, {kPad, 3, 4, 100}, 1, 16, 40, 55, "0"},
    {kTable, 0, 12, {kWind, 6, 1, 100}, 1, 32, 15, 25, "02"},
    {kTable, 0, 8, {kBass, 2, 1, 0}, 2, 16, 60, 75, kBassLine},
    {kTable, 8, 12, {kBass, 2, 1, 0}, 2, 16, 70, 80, "01"},
    {kTable, 0, 8, {kPiano, 4, 1, 100}, 1, 4, 70, 80, kTune},
    {kTable, 8, 12, {kPiano, 5, 1, 100}, 1, 4, 75, 70, kTune + kAnswer},
    {kTable, 1, 3, {kWood, 4, 1, 100}, 4, 16, 50, 60, "0.214.35"},
    {kTable, 3, 12, {kWood, 4, 1, 100}, 3, 16, 40, 55, "02143"},
    {kTable, 4, 12, {kBrush, 7, 1, 100}, 8, 16, 30, 50, "..a..aa."},
    {kTable, 8, 12, {kGlassDrop, 5, 1, 100}, 5, 32, 25, 50, "42.31"},

    {kFlake, 0, 1, {kDrum, 1, 1, 150}, 1, 16, 80, 80, "a"},
    {kFlake, 0, 1, {kImpact, 2, 1, 150}, 1, 16, 40, 40, "D"},
    {kFlake, 0, 6, {kBass, 2, 1, 0}, 2, 16, 60, 80, "01"},
    {kFlake, 6, 10, {kBass, 2, 1, 0}, 8, 16, 80, 90, "0--0--1-"},
    {kFlake, 6, 10, {kVoice, 2, 1, 100}, 1, 32, 60, 80, "1"},
    {kFlake, 0, 4, {kPiano, 5, 1, 120}, 1, 4, 55, 70, kMirrored},
    {kFlake, 1, 4, {kPiano, 4, 1, 100}, 8, 16, 35, 45, "0214352614253"},
    {kFlake, 4, 12, {kPiano, 5, 1, 120}, 1, 4, 65, 85, "F-Gbd--bc-dec--dd-cbG--ac--de---"},
    {kFlake, 2, 12, {kWood, 5, 1, 100}, 5, 16, 40, 70, "0314"},
    {kFlake, 3, 12, {kGlassDrop, 6, 1, 100}, 7, 16, 20, 45, "46253"},
    {kFlake, 4, 12, {kVoice, 4, 1, 100}, 1, 8, 60, 85, kTune},
    {kFlake, 4, 12, {kBrush, 7, 1, 100}, 8, 16, 25, 60, "..a..aa."},
    {kFlake, 6, 12, {kPad, 3, 4, 100}, 1, 16, 35, 80, "0"},
    {kFlake, 8, 12, {kPulse, 5, 1, 100}, 16, 16, 10, 60, "02132"},
    {kFlake, 10, 12, {kRiser, 6, 1, 100}, 1, 32, 70, 70, "a"},

    {kPatches, 0, kLight, {kPulse, 4, 1, 20}, 5, 16, 50, 70, "0"},
    {kPatches, 1, kLight, {kWood, 5, 1, 20}, 7, 16, 40, 60, "2"},
    {kPatches, 1, kLight, {kBrush, 8, 1, 20}, 5, 20, 20, 40, "D.DD.D."},
    {kPatches, 2, kLight, {kPulse, 5, 1, 20}, 7, 20, 30, 50, "20412"},
    {kPatches, kLight - 2, kLight, {kBass, 2, 1, 0}, 1, 16, 50, 80, "0"},
    {kPatches, kLight, kLightless, {kPad, 3, 4, 60}, 1, 16, 50, 70, "0"},
    {kPatches, kLight, kLightless, {kWind, 6, 1, 100}, 1, 16, 20, 20, "0241"},
    {kPatches, kLight, kLightless, {kBass, 2, 1, 0}, 1, 16, 60, 80, "0"},
    {kPatches, kLight + 3, kLight + 4, {kGlassDrop, 6, 1, 120}, 4, 16, 95, 95, ".024"}, // the photon's bounces
    {kPatches, kLight + 4, kLightless, {kPiano, 4, 1, 120}, 5, 16, 35, 50, "0243125"},
    {kPatches, kLightless - 4, kLightless, {kPiano, 5, 1, 120}, 1, 4, 65, 60, kMirrored},

    {kHall, 0, 1, {kDrum, 1, 1, 150}, 1, 16, 55, 55, "a"},
    {kHall, 0, left(8), {kWind, 5, 1, 100}, 1, 16, 20, 20, "024135"},
    {kHall, 0, left(4), {kPad, 3, 3, 60}, 1, 16, 55, 30, "0"},
    {kHall, 0, left(12), {kBass, 2, 1, 0}, 2, 16, 50, 55, "01"},
    {kHall, left(12), kDay, {kBass, 2, 1, 0}, 8, 16, 50, 50, "0--0--1-"},
    {kHall, left(14), left(2), {kBrush, 8, 1, 100}, 8, 16, 8, 30, ".D"},
    {kHall, left(16), left(10), {kVoice, 4, 1, 50}, 1, 4, 65, 70, kTune},
    {kHall, left(16), left(10), {kBreath, 5, 1, 100}, 1, 4, 20, 20, kTune},
    {kHall, left(10), left(8), {kVoice, 5, 1, 120}, 1, 4, 65, 50, kMirrored + 24},
    {kHall, 0, left(8), {kGlassDrop, 5, 1, 150}, 5, 32, 40, 35, "3142.50"},
    {kHall, left(9), left(8), {kGlassDrop, 5, 1, 150}, 1, 16, 70, 70, "0"}, // the cut to the lanterns
    {kHall, left(8), left(1), {kPiano, 4, 1, 120}, 1, 4, 60, 90, kTune},
    {kHall, kDoor - 1, kDoor, {kGlassDrop, 6, 1, 120}, 2, 16, 60, 60, "EC"},
    {kHall, kDoor - 2, kDoor, {kRiser, 6, 1, 100}, 1, 32, 35, 35, "a"},
    {kHall, kDoor, kDay, {kSub, 1, 1, 100}, 1, 16, 18, 30, "DDaa"},
    {kHall, left(4), kDay, {kVoice, 4, 1, 100}, 1, 4, 45, 60, "D-dcb--aGFECE-G-"},
    {kHall, left(4), kDay, {kPad, 3, 4, 100}, 1, 16, 20, 35, "0"},
    {kHall, left(4), kDay, {kPiano, 4, 1, 100}, 8, 16, 20, 45, "02143526143"},
    {kHall, left(2), kDay, {kWood, 4, 1, 120}, 4, 16, 50, 70, "0"},
    {kHall, left(2), kDay, {kBrush, 7, 1, 100}, 16, 16, 5, 50, "a"},
    {kHall, left(2), kDay, {kRiser, 6, 1, 100}, 1, 32, 45, 45, "a"},

    {kOdraz, 0, 12, {kPad, 3, 3, 85}, 1, 16, 45, 45, "0"},
    {kOdraz, 0, 8, {kBass, 2, 1, 0}, 2, 16, 90, 90, kBassLine},
    {kOdraz, 8, 12, {kBass, 2, 1, 0}, 2, 16, 65, 50, "01"},
    {kOdraz, 0, 8, {kSub, 1, 1, 100}, 1, 16, 35, 35, "DFbaDGaD"},
    {kOdraz, 0, 7, {kDrum, 1, 1, 60}, 2, 16, 90, 90, "a"},
    {kOdraz, 0, 7, {kImpact, 4, 1, 100}, 2, 16, 38, 36, "D"},
    {kOdraz, 0, 8, {kBrush, 7, 1, 100}, 16, 16, 50, 75, "a.aa"},
    {kOdraz, 0, 7, {kWood, 5, 1, 100}, 3, 8, 45, 45, "03142"},
    {kOdraz, 0, 8, {kPiano, 4, 1, 100}, 16, 16, 28, 40, ".214.526.425"},
    {kOdraz, 1, 9, {kGlassDrop, 6, 1, 100}, 5, 16, 55, 60, "42531"},
    {kOdraz, 0, 8, {kPiano, 5, 1, 30}, 1, 4, 90, 90, kTune},
    {kOdraz, 0, 8, {kVoice, 5, 1, 30}, 1, 4, 90, 90, kTune},
    {kOdraz, 0, 8, {kVoice, 6, 1, 30}, 1, 4, 36, 36, kTune},
    {kOdraz, 2, 8, {kVoice, 4, 1, 100, 80}, 1, 4, 50, 50, kMirrored},
    {kOdraz, 2, 8, {kGlassDrop, 4, 1, 150, 80}, 1, 4, 50, 50, kMirrored},
    {kOdraz, 8, 12, {kPiano, 4, 1, 120}, 1, 4, 70, 40, "D-dcb--aG-F-E-C-"},
    {kOdraz, 8, 12, {kBreath, 5, 1, 120}, 1, 4, 20, 10, "D-dcb--aG-F-E-C-"},
    {kOdraz, 10, 11, {kGlassDrop, 6, 1, 150}, 2, 16, 80, 80, ".a"},

    {kCredits, 0, 1, {kPiano, 2, 2, 150}, 1, 16, 60, 60, "0"},
    {kCredits, 0, 4, {kPad, 4, 5, 150}, 1, 68, 35, 35, "0"},
    {kCredits, 0, 2, {kWind, 6, 1, 100}, 1, 16, 20, 10, "0"},
    {kCredits, 2, 5, {kGlassDrop, 5, 1, 150}, 4, 16, 60, 45, "Ge..a-eFdE.."},
    {kCredits, 4, 5, {kPiano, 5, 2, 30}, 4, 16, 35, 35, "...D-"},
};

// Event; instrument, octave, tones at once, room; velocity; tone.
static constexpr EventSound kEventSounds[] = {
    {kLightIsBorn, {kGlassDrop, 6, 1, 120}, 60, '2'},
    {kLightGrows, {kGlassDrop, 5, 1, 120}, 60, '0'},
    {kRimLightWakes, {kGlassDrop, 6, 1, 120}, 50, 'E'},
    {kCausticFalls, {kGlassDrop, 5, 2, 120}, 60, '2'},
    {kWordComes, {kGlassDrop, 6, 1, 120}, 50, 'D'},
    {kWordStands, {kPiano, 2, 1, 120}, 90, 'D'},
    {kWordStands, {kDrum, 1, 1, 150}, 80, 'a'},
    {kBallsSetOff, {kWood, 4, 2, 120}, 80, '0'},
    {kGeneration1, {kPiano, 4, 3, 120}, 60, '0'},
    {kGeneration2, {kGlassDrop, 5, 3, 120}, 70, '0'},
    {kGeneration3, {kGlassDrop, 6, 4, 120}, 90, '0'},
    {kHallIsBlack, {kDrum, 1, 1, 30}, 90, 'a'},
    {kHallIsBlack, {kImpact, 2, 1, 50}, 60, 'D'},
    {kPatchIsVisited, {kGlassDrop, 5, 1, 30}, 70, 'D'},
    {kHalfCubeRises, {kGlassDrop, 4, 2, 40}, 60, '0'},
    {kHalfCubeOpens, {kGlassDrop, 5, 3, 40}, 70, '0'},
    {kPatchTakesColour, {kPiano, 4, 2, 60}, 70, '0'},
    {kHalfCubeCloses, {kGlassDrop, 4, 1, 40}, 60, 'D'},
    {kDirectLight, {kPiano, 3, 2, 80}, 100, '0'},
    {kDirectLight, {kDrum, 1, 1, 150}, 80, 'a'},
    {kDirectLight, {kImpact, 2, 1, 150}, 60, 'D'},
    {kBounce1, {kPiano, 3, 3, 100}, 80, '0'},
    {kBounce2, {kPiano, 3, 4, 120}, 80, '0'},
    {kBounce3, {kPiano, 3, 5, 150}, 80, '0'},
    {kLamp1, {kPiano, 5, 1, 150}, 70, 'a'},
    {kLamp2, {kPiano, 5, 1, 150}, 65, 'c'},
    {kLamp3, {kPiano, 5, 1, 150}, 60, 'd'},
    {kLightReturns, {kGlassDrop, 6, 1, 120}, 60, 'a'},
    {kLamp3Dies, {kGlassDrop, 5, 1, 150}, 60, 'D'},
    {kLamp2Dies, {kGlassDrop, 5, 1, 150}, 60, 'E'},
    {kLamp1Dies, {kGlassDrop, 5, 1, 150}, 60, 'F'},
    {kStrip1, {kDrum, 1, 1, 150}, 60, 'a'},
    {kStrip1, {kImpact, 2, 1, 150}, 45, 'D'},
    {kStrip1, {kPiano, 5, 1, 120}, 60, 'D'},
    {kStrip2, {kPiano, 5, 1, 120}, 62, 'E'},
    {kStrip3, {kPiano, 5, 1, 120}, 64, 'F'},
    {kStrip4, {kPiano, 5, 1, 120}, 66, 'G'},
    {kStrip5, {kPiano, 5, 1, 120}, 68, 'a'},
    {kStrip6, {kPiano, 5, 1, 120}, 70, 'b'},
    {kStrip7, {kPiano, 5, 1, 120}, 72, 'c'},
    {kStrip8, {kPiano, 5, 3, 120}, 74, 'd'},
    {kLampLights, {kPiano, 4, 1, 150}, 80, '0'},
    {kBall1, {kPiano, 3, 3, 120}, 100, '0'},
    {kBall1, {kImpact, 2, 1, 150}, 40, 'D'},
    {kBall2, {kGlassDrop, 6, 1, 120}, 90, '1'},
    {kBall3, {kWood, 4, 1, 120}, 70, '2'},
    {kBall4, {kWood, 4, 1, 120}, 70, '3'},
    {kBall5, {kWood, 4, 1, 120}, 70, '4'},
    {kBall5Leaves, {kWood, 4, 1, 120}, 60, '2'},
    {kBall4Leaves, {kWood, 4, 1, 120}, 60, '1'},
    {kDoorDies, {kGlassDrop, 5, 2, 120}, 70, '0'},
    {kOuterLampsDie, {kGlassDrop, 5, 2, 120}, 60, '2'},
    {kBall3Leaves, {kGlassDrop, 5, 1, 120}, 60, '1'},
    {kBall1Leaves, {kGlassDrop, 6, 1, 120}, 60, '0'},
    {kWordShines, {kGlassDrop, 6, 1, 150}, 90, 'D'},
    {kLine1, {kGlassDrop, 6, 1, 120}, 60, 'D'},
    {kLine2, {kGlassDrop, 6, 1, 120}, 60, 'a'},
};
// clang-format on

// The share of each side that the other takes, per cent: scene 4 is narrow until light comes, and the finale
// is the widest.
static int narrowAt(int scene, int bar) {
    static constexpr int8_t kNarrow[kSceneCount] = {
        [kPoint] = 15, [kTable] = 25, [kFlake] = 12,  [kPatches] = 16,
        [kHall] = 13,  [kOdraz] = 6,  [kCredits] = 10};
    return scene == kPatches && bar < kLight ? 35 : kNarrow[scene];
}

} // namespace odraz
