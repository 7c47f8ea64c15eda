// The film's music: chords for each bar, parts that play them, and sounds of events. score.cpp plays it.
#pragma once

#include "show/score.h"
#include "show/tune.h"

namespace odraz {

// clang-format off
// Scenes 4 (patches) and 5 (the day) share bars 32 to 64 of the film: kLightless bars, then kDay bars from kDayBegins
// on (a test compares it with the film). kLight: the bar of direct light, in scene 4. kDoor: the bar of the first
// strip of the door, in scene 5. left(n): n bars before the day's end.
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

// .bars: from, to. .sound: instrument, octave, tones at once, room, per cent to the left. .strokes: number, rows.
// .velocity: at the start, at the end.
static constexpr Part kParts[] = {
    {.scene = kPoint, .bars = {0, 5}, .sound = {kGlassDrop, 5, 1, 100}, .strokes = {5, 64}, .velocity = {50, 60}, .line = "..D.aG"},
    {.scene = kPoint, .bars = {0, 8}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 32}, .velocity = {8, 16}, .line = "0"},
    {.scene = kPoint, .bars = {5, 7}, .sound = {kGlassDrop, 5, 1, 100}, .strokes = {4, 16}, .velocity = {35, 60}, .line = "02140325"},
    {.scene = kPoint, .bars = {5, 7}, .sound = {kBrush, 7, 1, 100}, .strokes = {4, 16}, .velocity = {15, 30}, .line = "a"},
    {.scene = kPoint, .bars = {5, 8}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {30, 80}, .line = "0"},
    {.scene = kPoint, .bars = {6, 8}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 32}, .velocity = {20, 20}, .line = "a"},

    {.scene = kTable, .bars = {0, 1}, .sound = {kDrum, 1, 1, 150}, .strokes = {1, 16}, .velocity = {80, 80}, .line = "a"},
    {.scene = kTable, .bars = {0, 1}, .sound = {kImpact, 2, 1, 150}, .strokes = {1, 16}, .velocity = {40, 40}, .line = "D"},
    {.scene = kTable, .bars = {0, 12}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {40, 55}, .line = "0"},
    {.scene = kTable, .bars = {0, 12}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 32}, .velocity = {15, 25}, .line = "02"},
    {.scene = kTable, .bars = {0, 8}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {60, 75}, .line = kBassLine},
    {.scene = kTable, .bars = {8, 12}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {70, 80}, .line = "01"},
    {.scene = kTable, .bars = {0, 8}, .sound = {kPiano, 4, 1, 100}, .strokes = {1, 4}, .velocity = {70, 80}, .line = kTune},
    {.scene = kTable, .bars = {8, 12}, .sound = {kPiano, 5, 1, 100}, .strokes = {1, 4}, .velocity = {75, 70}, .line = kTune + kAnswer},
    {.scene = kTable, .bars = {1, 3}, .sound = {kWood, 4, 1, 100}, .strokes = {4, 16}, .velocity = {50, 60}, .line = "0.214.35"},
    {.scene = kTable, .bars = {3, 12}, .sound = {kWood, 4, 1, 100}, .strokes = {3, 16}, .velocity = {40, 55}, .line = "02143"},
    {.scene = kTable, .bars = {4, 12}, .sound = {kBrush, 7, 1, 100}, .strokes = {8, 16}, .velocity = {30, 50}, .line = "..a..aa."},
    {.scene = kTable, .bars = {8, 12}, .sound = {kGlassDrop, 5, 1, 100}, .strokes = {5, 32}, .velocity = {25, 50}, .line = "42.31"},

    {.scene = kFlake, .bars = {0, 1}, .sound = {kDrum, 1, 1, 150}, .strokes = {1, 16}, .velocity = {80, 80}, .line = "a"},
    {.scene = kFlake, .bars = {0, 1}, .sound = {kImpact, 2, 1, 150}, .strokes = {1, 16}, .velocity = {40, 40}, .line = "D"},
    {.scene = kFlake, .bars = {0, 6}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {60, 80}, .line = "01"},
    {.scene = kFlake, .bars = {6, 10}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {80, 90}, .line = "0--0--1-"},
    {.scene = kFlake, .bars = {6, 10}, .sound = {kVoice, 2, 1, 100}, .strokes = {1, 32}, .velocity = {60, 80}, .line = "1"},
    {.scene = kFlake, .bars = {0, 4}, .sound = {kPiano, 5, 1, 120}, .strokes = {1, 4}, .velocity = {55, 70}, .line = kMirrored},
    {.scene = kFlake, .bars = {1, 4}, .sound = {kPiano, 4, 1, 100}, .strokes = {8, 16}, .velocity = {35, 45}, .line = "0214352614253"},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kPiano, 5, 1, 120}, .strokes = {1, 4}, .velocity = {65, 85}, .line = "F-Gbd--bc-dec--dd-cbG--ac--de---"},
    {.scene = kFlake, .bars = {2, 12}, .sound = {kWood, 5, 1, 100}, .strokes = {5, 16}, .velocity = {40, 70}, .line = "0314"},
    {.scene = kFlake, .bars = {3, 12}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {7, 16}, .velocity = {20, 45}, .line = "46253"},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kVoice, 4, 1, 100}, .strokes = {1, 8}, .velocity = {60, 85}, .line = kTune},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kBrush, 7, 1, 100}, .strokes = {8, 16}, .velocity = {25, 60}, .line = "..a..aa."},
    {.scene = kFlake, .bars = {6, 12}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {35, 80}, .line = "0"},
    {.scene = kFlake, .bars = {8, 12}, .sound = {kPulse, 5, 1, 100}, .strokes = {16, 16}, .velocity = {10, 60}, .line = "02132"},
    {.scene = kFlake, .bars = {10, 12}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 32}, .velocity = {70, 70}, .line = "a"},

    {.scene = kPatches, .bars = {0, kLight}, .sound = {kPulse, 4, 1, 20}, .strokes = {5, 16}, .velocity = {50, 70}, .line = "0"},
    {.scene = kPatches, .bars = {1, kLight}, .sound = {kWood, 5, 1, 20}, .strokes = {7, 16}, .velocity = {40, 60}, .line = "2"},
    {.scene = kPatches, .bars = {1, kLight}, .sound = {kBrush, 8, 1, 20}, .strokes = {5, 20}, .velocity = {20, 40}, .line = "D.DD.D."},
    {.scene = kPatches, .bars = {2, kLight}, .sound = {kPulse, 5, 1, 20}, .strokes = {7, 20}, .velocity = {30, 50}, .line = "20412"},
    {.scene = kPatches, .bars = {kLight - 2, kLight}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 16}, .velocity = {50, 80}, .line = "0"},
    {.scene = kPatches, .bars = {kLight, kLightless}, .sound = {kPad, 3, 4, 60}, .strokes = {1, 16}, .velocity = {50, 70}, .line = "0"},
    {.scene = kPatches, .bars = {kLight, kLightless}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 16}, .velocity = {20, 20}, .line = "0241"},
    {.scene = kPatches, .bars = {kLight, kLightless}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 16}, .velocity = {60, 80}, .line = "0"},
    {.scene = kPatches, .bars = {kLight + 3, kLight + 4}, .sound = {kGlassDrop, 6, 1, 120}, .strokes = {4, 16}, .velocity = {95, 95}, .line = ".024"}, // the photon's bounces
    {.scene = kPatches, .bars = {kLight + 4, kLightless}, .sound = {kPiano, 4, 1, 120}, .strokes = {5, 16}, .velocity = {35, 50}, .line = "0243125"},
    {.scene = kPatches, .bars = {kLightless - 4, kLightless}, .sound = {kPiano, 5, 1, 120}, .strokes = {1, 4}, .velocity = {65, 60}, .line = kMirrored},

    {.scene = kHall, .bars = {0, 1}, .sound = {kDrum, 1, 1, 150}, .strokes = {1, 16}, .velocity = {55, 55}, .line = "a"},
    {.scene = kHall, .bars = {0, left(8)}, .sound = {kWind, 5, 1, 100}, .strokes = {1, 16}, .velocity = {20, 20}, .line = "024135"},
    {.scene = kHall, .bars = {0, left(4)}, .sound = {kPad, 3, 3, 60}, .strokes = {1, 16}, .velocity = {55, 30}, .line = "0"},
    {.scene = kHall, .bars = {0, left(12)}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {50, 55}, .line = "01"},
    {.scene = kHall, .bars = {left(12), kDay}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {50, 50}, .line = "0--0--1-"},
    {.scene = kHall, .bars = {left(14), left(2)}, .sound = {kBrush, 8, 1, 100}, .strokes = {8, 16}, .velocity = {8, 30}, .line = ".D"},
    {.scene = kHall, .bars = {left(16), left(10)}, .sound = {kVoice, 4, 1, 50}, .strokes = {1, 4}, .velocity = {65, 70}, .line = kTune},
    {.scene = kHall, .bars = {left(16), left(10)}, .sound = {kBreath, 5, 1, 100}, .strokes = {1, 4}, .velocity = {20, 20}, .line = kTune},
    {.scene = kHall, .bars = {left(10), left(8)}, .sound = {kVoice, 5, 1, 120}, .strokes = {1, 4}, .velocity = {65, 50}, .line = kMirrored + 24},
    {.scene = kHall, .bars = {0, left(8)}, .sound = {kGlassDrop, 5, 1, 150}, .strokes = {5, 32}, .velocity = {40, 35}, .line = "3142.50"},
    {.scene = kHall, .bars = {left(9), left(8)}, .sound = {kGlassDrop, 5, 1, 150}, .strokes = {1, 16}, .velocity = {70, 70}, .line = "0"}, // the cut to the lanterns
    {.scene = kHall, .bars = {left(8), left(1)}, .sound = {kPiano, 4, 1, 120}, .strokes = {1, 4}, .velocity = {60, 90}, .line = kTune},
    {.scene = kHall, .bars = {kDoor - 1, kDoor}, .sound = {kGlassDrop, 6, 1, 120}, .strokes = {2, 16}, .velocity = {60, 60}, .line = "EC"},
    {.scene = kHall, .bars = {kDoor - 2, kDoor}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 32}, .velocity = {35, 35}, .line = "a"},
    {.scene = kHall, .bars = {kDoor, kDay}, .sound = {kSub, 1, 1, 100}, .strokes = {1, 16}, .velocity = {18, 30}, .line = "DDaa"},
    {.scene = kHall, .bars = {left(4), kDay}, .sound = {kVoice, 4, 1, 100}, .strokes = {1, 4}, .velocity = {45, 60}, .line = "D-dcb--aGFECE-G-"},
    {.scene = kHall, .bars = {left(4), kDay}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {20, 35}, .line = "0"},
    {.scene = kHall, .bars = {left(4), kDay}, .sound = {kPiano, 4, 1, 100}, .strokes = {8, 16}, .velocity = {20, 45}, .line = "02143526143"},
    {.scene = kHall, .bars = {left(2), kDay}, .sound = {kWood, 4, 1, 120}, .strokes = {4, 16}, .velocity = {50, 70}, .line = "0"},
    {.scene = kHall, .bars = {left(2), kDay}, .sound = {kBrush, 7, 1, 100}, .strokes = {16, 16}, .velocity = {5, 50}, .line = "a"},
    {.scene = kHall, .bars = {left(2), kDay}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 32}, .velocity = {45, 45}, .line = "a"},

    {.scene = kOdraz, .bars = {0, 12}, .sound = {kPad, 3, 3, 85}, .strokes = {1, 16}, .velocity = {45, 45}, .line = "0"},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {90, 90}, .line = kBassLine},
    {.scene = kOdraz, .bars = {8, 12}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {65, 50}, .line = "01"},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kSub, 1, 1, 100}, .strokes = {1, 16}, .velocity = {35, 35}, .line = "DFbaDGaD"},
    {.scene = kOdraz, .bars = {0, 7}, .sound = {kDrum, 1, 1, 60}, .strokes = {2, 16}, .velocity = {90, 90}, .line = "a"},
    {.scene = kOdraz, .bars = {0, 7}, .sound = {kImpact, 4, 1, 100}, .strokes = {2, 16}, .velocity = {38, 36}, .line = "D"},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kBrush, 7, 1, 100}, .strokes = {16, 16}, .velocity = {50, 75}, .line = "a.aa"},
    {.scene = kOdraz, .bars = {0, 7}, .sound = {kWood, 5, 1, 100}, .strokes = {3, 8}, .velocity = {45, 45}, .line = "03142"},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kPiano, 4, 1, 100}, .strokes = {16, 16}, .velocity = {28, 40}, .line = ".214.526.425"},
    {.scene = kOdraz, .bars = {1, 9}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {5, 16}, .velocity = {55, 60}, .line = "42531"},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kPiano, 5, 1, 30}, .strokes = {1, 4}, .velocity = {90, 90}, .line = kTune},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kVoice, 5, 1, 30}, .strokes = {1, 4}, .velocity = {90, 90}, .line = kTune},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kVoice, 6, 1, 30}, .strokes = {1, 4}, .velocity = {36, 36}, .line = kTune},
    {.scene = kOdraz, .bars = {2, 8}, .sound = {kVoice, 4, 1, 100, 80}, .strokes = {1, 4}, .velocity = {50, 50}, .line = kMirrored},
    {.scene = kOdraz, .bars = {2, 8}, .sound = {kGlassDrop, 4, 1, 150, 80}, .strokes = {1, 4}, .velocity = {50, 50}, .line = kMirrored},
    {.scene = kOdraz, .bars = {8, 12}, .sound = {kPiano, 4, 1, 120}, .strokes = {1, 4}, .velocity = {70, 40}, .line = "D-dcb--aG-F-E-C-"},
    {.scene = kOdraz, .bars = {8, 12}, .sound = {kBreath, 5, 1, 120}, .strokes = {1, 4}, .velocity = {20, 10}, .line = "D-dcb--aG-F-E-C-"},
    {.scene = kOdraz, .bars = {10, 11}, .sound = {kGlassDrop, 6, 1, 150}, .strokes = {2, 16}, .velocity = {80, 80}, .line = ".a"},

    {.scene = kCredits, .bars = {0, 1}, .sound = {kPiano, 2, 2, 150}, .strokes = {1, 16}, .velocity = {60, 60}, .line = "0"},
    {.scene = kCredits, .bars = {0, 4}, .sound = {kPad, 4, 5, 150}, .strokes = {1, 68}, .velocity = {35, 35}, .line = "0"},
    {.scene = kCredits, .bars = {0, 2}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 16}, .velocity = {20, 10}, .line = "0"},
    {.scene = kCredits, .bars = {2, 5}, .sound = {kGlassDrop, 5, 1, 150}, .strokes = {4, 16}, .velocity = {60, 45}, .line = "Ge..a-eFdE.."},
    {.scene = kCredits, .bars = {4, 5}, .sound = {kPiano, 5, 2, 30}, .strokes = {4, 16}, .velocity = {35, 35}, .line = "...D-"},
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
    {kHemicubeRises, {kGlassDrop, 4, 2, 40}, 60, '0'},
    {kHemicubeOpens, {kGlassDrop, 5, 3, 40}, 70, '0'},
    {kPatchTakesColour, {kPiano, 4, 2, 60}, 70, '0'},
    {kHemicubeCloses, {kGlassDrop, 4, 1, 40}, 60, 'D'},
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

// Returns the crossfeed in per cent (mixer.h). The sound is narrow before direct light, widest in the finale.
static int crossfeedAt(int scene, int bar) {
    static constexpr int8_t kCrossfeed[kSceneCount] = {
        [kPoint] = 15, [kTable] = 25, [kFlake] = 12,  [kPatches] = 16,
        [kHall] = 13,  [kOdraz] = 6,  [kCredits] = 10};
    return scene == kPatches && bar < kLight ? 35 : kCrossfeed[scene];
}

} // namespace odraz
