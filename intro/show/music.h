// The film's music: chords for each bar, parts that play them, and sounds of events. score.cpp plays it.
#pragma once

#include "show/length.h"
#include "show/score.h"
#include "show/tune.h"

namespace odraz {

// clang-format off
constexpr const char *const kChords[kSceneCount] = { // rows in the enum's order
    [kPoint] = "DDDDDA",
    [kTable] = "DFBADGADBG",
    [kFlake] = "DBCDBFCDBFGA",
    [kPatches] = "DDDADBGCFCFBF",
    [kHall] = "BCBGADGDDBADFDG",
    [kOdraz] = "DFBADGADDADFDDeadd",
    [kCredits] = "dddddddd",
};

// The level of each bar of the film in dB, applied after the compressor.
static constexpr int8_t kLevels[(int)kEndRow / 16] = {
    -10, -5, -9, -4, -4, -3, // from bar 0
    -7, -4, -3, -3, -4, -3, -4, -2, -2, -5, // from bar 6
    -10, -2, -2, -2, -3, -4, -2, -2, -2, -2, -1, -1, // from bar 16
    -13, -8, -4, -5, -2, -2, -2, -3, -8, -5, -4, -4, -4, // from bar 28
    -2, -6, -8, -10, -13, -7, -6, -4, -4, -3, -1, -2, -3, 0, 0, // from bar 41
    0, 0, 0, 0, 0, 0, -2, 0, 1, 0, 1, 0, -8, -4, -11, -6, -8, -4, // from bar 56
    -2, -6, -7, -10, -12, -14, -11, -16, // from bar 74
};

// .bars: from, to. .sound: instrument, octave, tones at once, room, per cent to the left. .strokes: number, rows.
// .velocity: at the start, at the end.
static constexpr Part kParts[] = {
    // A ping, and its answer from the stone. The cell, low D, the word a note a stroke: open fifths
    {.scene = kPoint, .bars = {0, 6}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 32}, .velocity = {6, 20}, .line = "D"},
    {.scene = kPoint, .bars = {0, 2}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {4, 16}, .velocity = {30, 30}, .line = ".D...A.."},
    {.scene = kPoint, .bars = {2, 3}, .sound = {kGlassDrop, 5, 1, 100, -60}, .strokes = {4, 16}, .velocity = {50, 50}, .line = kCell},
    {.scene = kPoint, .bars = {2, 4}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {4, 16}, .velocity = {30, 30}, .line = ".aEDA..."},
    {.scene = kPoint, .bars = {3, 5}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {16, 16}, .velocity = {8, 20}, .line = "aDEa"},
    {.scene = kPoint, .bars = {2, 6}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 32}, .velocity = {30, 60}, .line = "D"},
    {.scene = kPoint, .bars = {3, 6}, .sound = {kPad, 3, 1, 100}, .strokes = {1, 48}, .velocity = {30, 30}, .line = "a"},
    {.scene = kPoint, .bars = {4, 6}, .sound = {kPad, 4, 1, 100}, .strokes = {1, 32}, .velocity = {40, 40}, .line = "D"},
    {.scene = kPoint, .bars = {4, 6}, .sound = {kPiano, 5, 1, 100}, .strokes = {4, 16}, .velocity = {40, 70}, .line = "DEGaDEad"},
    {.scene = kPoint, .bars = {4, 6}, .sound = {kBrush, 8, 1, 100}, .strokes = {4, 16}, .velocity = {12, 30}, .line = "D"},
    {.scene = kPoint, .bars = {5, 6}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 16}, .velocity = {50, 50}, .line = "a"},

    // The tune among the balls
    {.scene = kTable, .bars = {0, 1}, .sound = {kGlassDrop, 5, 1, 100, -60}, .strokes = {8, 16}, .velocity = {60, 60}, .line = kCell},
    {.scene = kTable, .bars = {0, 1}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {40, 40}, .line = kCellAnswer},
    {.scene = kTable, .bars = {0, 8}, .sound = {kPiano, 4, 1, 100}, .strokes = {1, 4}, .velocity = {80, 90}, .line = kTune},
    {.scene = kTable, .bars = {8, 10}, .sound = {kPiano, 5, 1, 100}, .strokes = {1, 4}, .velocity = {80, 90}, .line = kTune + kAnswer},
    {.scene = kTable, .bars = {0, 8}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {60, 80}, .line = kBassLine},
    {.scene = kTable, .bars = {8, 10}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {60, 90}, .line = "0"},
    {.scene = kTable, .bars = {1, 10}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {40, 60}, .line = "0"},
    {.scene = kTable, .bars = {0, 10}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 32}, .velocity = {20, 30}, .line = "02"},
    {.scene = kTable, .bars = {1, 10}, .sound = {kWood, 4, 1, 100}, .strokes = {5, 16}, .velocity = {50, 60}, .line = "02143"},
    {.scene = kTable, .bars = {3, 6}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {4, 16}, .velocity = {50, 40}, .line = "0213"},
    {.scene = kTable, .bars = {3, 10}, .sound = {kHat, 8, 1, 100}, .strokes = {8, 16}, .velocity = {50, 70}, .line = "D.DD.DD."},
    {.scene = kTable, .bars = {5, 10}, .sound = {kBrush, 7, 1, 100}, .strokes = {4, 16}, .velocity = {30, 50}, .line = ".a"},
    {.scene = kTable, .bars = {6, 8}, .sound = {kDrum, 1, 1, 60}, .strokes = {2, 16}, .velocity = {50, 50}, .line = "a"},
    {.scene = kTable, .bars = {7, 8}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {50, 50}, .line = kCellAnswer},
    {.scene = kTable, .bars = {8, 10}, .sound = {kVoice, 4, 2, 100}, .strokes = {1, 16}, .velocity = {40, 80}, .line = "0"},
    {.scene = kTable, .bars = {8, 10}, .sound = {kHat, 8, 1, 100}, .strokes = {16, 16}, .velocity = {10, 60}, .line = "D"},
    {.scene = kTable, .bars = {8, 10}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 30}, .velocity = {60, 60}, .line = "a."},

    // Three hits, each a step up; drums, then sixteenths
    {.scene = kFlake, .bars = {0, 1}, .sound = {kGlassDrop, 5, 1, 100, -60}, .strokes = {8, 16}, .velocity = {40, 40}, .line = kCell},
    {.scene = kFlake, .bars = {0, 1}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {30, 30}, .line = kCellAnswer},
    {.scene = kFlake, .bars = {0, 12}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 32}, .velocity = {12, 20}, .line = "02"},
    {.scene = kFlake, .bars = {1, 4}, .sound = {kWood, 4, 1, 100}, .strokes = {8, 16}, .velocity = {40, 70}, .line = ".0214352"},
    {.scene = kFlake, .bars = {1, 4}, .sound = {kHat, 8, 1, 100}, .strokes = {8, 16}, .velocity = {50, 80}, .line = "..D..DD."},
    {.scene = kFlake, .bars = {1, 12}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {40, 50}, .line = "0"},
    {.scene = kFlake, .bars = {1, 4}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 16}, .velocity = {30, 50}, .line = "0"},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {70, 80}, .line = "0---..2-"},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kDrum, 1, 1, 60}, .strokes = {8, 16}, .velocity = {90, 90}, .line = "a...a.a."},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kPiano, 5, 1, 100}, .strokes = {1, 4}, .velocity = {70, 80}, .line = kFlight},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kVoice, 4, 1, 100}, .strokes = {1, 4}, .velocity = {50, 60}, .line = kFlight},
    {.scene = kFlake, .bars = {4, 7}, .sound = {kHat, 8, 1, 100}, .strokes = {8, 16}, .velocity = {50, 60}, .line = "D"},
    {.scene = kFlake, .bars = {7, 12}, .sound = {kHat, 8, 1, 100}, .strokes = {16, 16}, .velocity = {50, 80}, .line = "D.DD"},
    {.scene = kFlake, .bars = {4, 12}, .sound = {kBrush, 7, 1, 100}, .strokes = {4, 16}, .velocity = {40, 50}, .line = ".a"},
    {.scene = kFlake, .bars = {7, 12}, .sound = {kPulse, 5, 1, 100}, .strokes = {16, 16}, .velocity = {20, 60}, .line = "02132"},
    {.scene = kFlake, .bars = {7, 10}, .sound = {kBrush, 6, 1, 100, 60}, .strokes = {2, 16}, .velocity = {60, 70}, .line = "a"},
    {.scene = kFlake, .bars = {7, 12}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {7, 16}, .velocity = {30, 50}, .line = "42031"},
    {.scene = kFlake, .bars = {10, 12}, .sound = {kVoice, 4, 2, 100}, .strokes = {1, 16}, .velocity = {40, 60}, .line = "0"},
    {.scene = kFlake, .bars = {10, 12}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 32}, .velocity = {50, 50}, .line = "a"},

    // The cell, dry and alone; clockwork
    {.scene = kPatches, .bars = {0, 2}, .sound = {kGlassDrop, 5, 1, 10, -60}, .strokes = {8, 16}, .velocity = {60, 60}, .line = "....ADEa........"},
    {.scene = kPatches, .bars = {0, 2}, .sound = {kGlassDrop, 5, 1, 10, 60}, .strokes = {8, 16}, .velocity = {40, 40}, .line = "......aEDA......"},
    {.scene = kPatches, .bars = {1, 4}, .sound = {kHat, 8, 1, 20}, .strokes = {8, 16}, .velocity = {8, 40}, .line = "D"},
    {.scene = kPatches, .bars = {2, 4}, .sound = {kWood, 5, 1, 20}, .strokes = {8, 16}, .velocity = {40, 70}, .line = "0.202.02"},
    {.scene = kPatches, .bars = {2, 4}, .sound = {kPulse, 4, 1, 20}, .strokes = {5, 16}, .velocity = {40, 80}, .line = "0"},
    {.scene = kPatches, .bars = {2, 4}, .sound = {kPulse, 5, 1, 20}, .strokes = {16, 16}, .velocity = {20, 50}, .line = "20312"},
    {.scene = kPatches, .bars = {3, 4}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {40, 80}, .line = "0"},

    // A voice more with each bounce; in the last bar all four, one a beat
    {.scene = kPatches, .bars = {4, 8}, .sound = {kVoice, 4, 1, 60}, .strokes = {1, 16}, .velocity = {60, 80}, .line = "DDDE"},
    {.scene = kPatches, .bars = {5, 8}, .sound = {kVoice, 4, 1, 100, 60}, .strokes = {1, 16}, .velocity = {60, 80}, .line = "FGG"},
    {.scene = kPatches, .bars = {6, 8}, .sound = {kVoice, 4, 1, 100, -60}, .strokes = {1, 16}, .velocity = {60, 80}, .line = "b"},
    {.scene = kPatches, .bars = {7, 8}, .sound = {kPiano, 5, 1, 100}, .strokes = {4, 16}, .velocity = {80, 90}, .line = "EGbc"},
    {.scene = kPatches, .bars = {4, 8}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {50, 70}, .line = "0"},
    {.scene = kPatches, .bars = {4, 8}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 16}, .velocity = {60, 70}, .line = "0"},
    {.scene = kPatches, .bars = {4, 8}, .sound = {kHat, 8, 1, 100}, .strokes = {8, 16}, .velocity = {60, 80}, .line = "..D..DD."},

    // F major: the cell in the beam, then the tune over other chords, which follow it into the hall
    {.scene = kPatches, .bars = {8, 9}, .sound = {kGlassDrop, 5, 1, 100, -60}, .strokes = {8, 16}, .velocity = {60, 60}, .line = kCell},
    {.scene = kPatches, .bars = {8, 9}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {40, 40}, .line = kCellAnswer},
    {.scene = kPatches, .bars = {8, 13}, .sound = {kPad, 3, 3, 100}, .strokes = {1, 16}, .velocity = {30, 40}, .line = "0"},
    {.scene = kPatches, .bars = {8, 13}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 16}, .velocity = {50, 50}, .line = "0"},
    {.scene = kPatches, .bars = {8, 13}, .sound = {kWind, 7, 1, 100}, .strokes = {1, 16}, .velocity = {30, 30}, .line = "0241"},
    {.scene = kPatches, .bars = {8, 11}, .sound = {kPiano, 4, 1, 100}, .strokes = {8, 16}, .velocity = {30, 40}, .line = "02143526"},
    {.scene = kPatches, .bars = {11, 13}, .sound = {kPiano, 5, 1, 100}, .strokes = {1, 4}, .velocity = {50, 80}, .line = kTune},
    {.scene = kPatches, .bars = {11, 13}, .sound = {kVoice, 4, 1, 100}, .strokes = {1, 4}, .velocity = {30, 40}, .line = kTune},
    {.scene = kPatches, .bars = {11, 13}, .sound = {kGlassDrop, 4, 1, 150}, .strokes = {1, 16}, .velocity = {50, 50}, .line = "DF"},
    {.scene = kPatches, .bars = {11, 13}, .sound = {kBrush, 3, 1, 100}, .strokes = {16, 16}, .velocity = {20, 40}, .line = "a"}, // the ball rolls
    {.scene = kPatches, .bars = {11, 13}, .sound = {kGlassDrop, 7, 1, 100}, .strokes = {4, 16}, .velocity = {30, 30}, .line = ".0.2"},

    // The tune goes on, a bell climbs to noon and falls, the canon follows, one A is held
    {.scene = kHall, .bars = {0, 2}, .sound = {kPiano, 5, 1, 100}, .strokes = {1, 4}, .velocity = {70, 40}, .line = kTune + 8},
    {.scene = kHall, .bars = {2, 6}, .sound = {kPiano, 5, 1, 100}, .strokes = {1, 4}, .velocity = {40, 70}, .line = kTune + kAnswer},
    {.scene = kHall, .bars = {0, 6}, .sound = {kVoice, 4, 1, 100}, .strokes = {1, 4}, .velocity = {40, 30}, .line = kTune + 8},
    {.scene = kHall, .bars = {0, 8}, .sound = {kVoice, 4, 1, 100, 60}, .strokes = {1, 4}, .velocity = {40, 40}, .line = kMirrored},
    {.scene = kHall, .bars = {0, 5}, .sound = {kGlassDrop, 4, 1, 150}, .strokes = {1, 16}, .velocity = {70, 50}, .line = "bedbG"},
    {.scene = kHall, .bars = {0, 4}, .sound = {kPiano, 3, 2, 100}, .strokes = {1, 48}, .velocity = {50, 50}, .line = "0"}, // the cuts
    {.scene = kHall, .bars = {0, 5}, .sound = {kVoice, 5, 1, 100}, .strokes = {1, 80}, .velocity = {20, 20}, .line = "a"},
    {.scene = kHall, .bars = {0, 5}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 16}, .velocity = {50, 40}, .line = "0"},
    {.scene = kHall, .bars = {0, 11}, .sound = {kPad, 3, 3, 60}, .strokes = {1, 16}, .velocity = {40, 30}, .line = "0"},
    {.scene = kHall, .bars = {0, 11}, .sound = {kWind, 7, 1, 100}, .strokes = {1, 16}, .velocity = {30, 20}, .line = "024135"},
    {.scene = kHall, .bars = {4, 6}, .sound = {kGlassDrop, 5, 1, 100, -60}, .strokes = {8, 16}, .velocity = {50, 50}, .line = "....ADEa........"},
    {.scene = kHall, .bars = {4, 6}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {30, 30}, .line = "......aEDA......"},

    // Night
    {.scene = kHall, .bars = {5, 11}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {40, 50}, .line = "0--0--1-"},
    {.scene = kHall, .bars = {5, 11}, .sound = {kHat, 8, 1, 100}, .strokes = {8, 16}, .velocity = {30, 60}, .line = ".D"},
    {.scene = kHall, .bars = {8, 9}, .sound = {kGlassDrop, 5, 1, 100, -60}, .strokes = {8, 16}, .velocity = {70, 70}, .line = kCell},
    {.scene = kHall, .bars = {8, 9}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {50, 50}, .line = kCellAnswer},
    {.scene = kHall, .bars = {8, 11}, .sound = {kPiano, 4, 1, 100}, .strokes = {8, 16}, .velocity = {30, 50}, .line = "02143526"},
    {.scene = kHall, .bars = {10, 11}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 16}, .velocity = {60, 60}, .line = "a"},

    // The strips: a scale, the floor's answer; then a rhythm
    {.scene = kHall, .bars = {11, 13}, .sound = {kPiano, 5, 1, 100}, .strokes = {4, 16}, .velocity = {60, 80}, .line = "DEFGabcd"},
    {.scene = kHall, .bars = {11, 13}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {4, 16}, .velocity = {50, 70}, .line = "DEFGabcd"},
    {.scene = kHall, .bars = {11, 13}, .sound = {kVoice, 4, 1, 100, 60}, .strokes = {4, 16}, .velocity = {40, 60}, .line = "..DEFGab"},
    {.scene = kHall, .bars = {11, 15}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {50, 70}, .line = "0"},
    {.scene = kHall, .bars = {11, 15}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {40, 60}, .line = "0"},
    {.scene = kHall, .bars = {11, 15}, .sound = {kHat, 8, 1, 100}, .strokes = {16, 16}, .velocity = {20, 80}, .line = "D.DD"},
    {.scene = kHall, .bars = {13, 15}, .sound = {kPiano, 5, 1, 100}, .strokes = {8, 16}, .velocity = {80, 90}, .line = kDoorTune},
    {.scene = kHall, .bars = {13, 15}, .sound = {kPulse, 5, 1, 100}, .strokes = {8, 16}, .velocity = {80, 90}, .line = kDoorTune},
    {.scene = kHall, .bars = {13, 15}, .sound = {kDrum, 1, 1, 60}, .strokes = {2, 16}, .velocity = {90, 90}, .line = "a"},
    {.scene = kHall, .bars = {11, 13}, .sound = {kBrush, 3, 1, 100}, .strokes = {16, 16}, .velocity = {12, 30}, .line = "a"}, // the ball rolls
    {.scene = kHall, .bars = {13, 15}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 32}, .velocity = {60, 60}, .line = "a"},

    // The climax: the tune in octaves, from bar 4 a tone up; the kit
    {.scene = kOdraz, .bars = {0, 4}, .sound = {kDrum, 1, 1, 60}, .strokes = {2, 16}, .velocity = {90, 90}, .line = "a"},
    {.scene = kOdraz, .bars = {4, 12}, .sound = {kDrum, 1, 1, 60}, .strokes = {4, 16}, .velocity = {90, 90}, .line = "a"},
    {.scene = kOdraz, .bars = {0, 9}, .sound = {kBrush, 7, 1, 100}, .strokes = {4, 16}, .velocity = {80, 90}, .line = ".a"},
    {.scene = kOdraz, .bars = {0, 4}, .sound = {kHat, 8, 1, 100}, .strokes = {8, 16}, .velocity = {70, 80}, .line = "D"},
    {.scene = kOdraz, .bars = {4, 12}, .sound = {kHat, 8, 1, 100}, .strokes = {16, 16}, .velocity = {70, 90}, .line = "D.DD"},
    {.scene = kOdraz, .bars = {3, 4}, .sound = {kBrush, 7, 1, 100}, .strokes = {16, 16}, .velocity = {20, 90}, .line = ".........aa.aaaa"},
    {.scene = kOdraz, .bars = {7, 8}, .sound = {kBrush, 7, 1, 100}, .strokes = {16, 16}, .velocity = {20, 90}, .line = ".........aa.aaaa"},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kPiano, 5, 1, 60}, .strokes = {1, 4}, .velocity = {90, 90}, .line = kTune},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kPiano, 4, 1, 60}, .strokes = {1, 4}, .velocity = {80, 80}, .line = kTune},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kVoice, 5, 1, 60}, .strokes = {1, 4}, .velocity = {80, 90}, .line = kTune},
    {.scene = kOdraz, .bars = {4, 8}, .sound = {kVoice, 6, 1, 60}, .strokes = {1, 4}, .velocity = {40, 50}, .line = kTune + kAnswer},
    {.scene = kOdraz, .bars = {0, 2}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {4, 16}, .velocity = {50, 50}, .line = "..aEDA.."},
    {.scene = kOdraz, .bars = {1, 4}, .sound = {kWood, 5, 1, 100}, .strokes = {4, 16}, .velocity = {50, 50}, .line = "0"},
    {.scene = kOdraz, .bars = {2, 8}, .sound = {kVoice, 4, 1, 100, 60}, .strokes = {1, 4}, .velocity = {50, 60}, .line = kMirrored},
    {.scene = kOdraz, .bars = {0, 2}, .sound = {kBass, 2, 1, 0}, .strokes = {2, 16}, .velocity = {80, 80}, .line = kBassLine},
    {.scene = kOdraz, .bars = {2, 12}, .sound = {kBass, 2, 1, 0}, .strokes = {8, 16}, .velocity = {80, 90}, .line = "0"},
    {.scene = kOdraz, .bars = {0, 12}, .sound = {kPad, 3, 3, 60}, .strokes = {1, 16}, .velocity = {50, 60}, .line = "0"},
    {.scene = kOdraz, .bars = {0, 8}, .sound = {kPiano, 4, 1, 100}, .strokes = {16, 16}, .velocity = {30, 50}, .line = ".213.123.021"},
    {.scene = kOdraz, .bars = {1, 8}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {5, 16}, .velocity = {50, 60}, .line = "42031"},
    {.scene = kOdraz, .bars = {6, 8}, .sound = {kVoice, 4, 2, 100}, .strokes = {1, 8}, .velocity = {60, 80}, .line = "0"},
    {.scene = kOdraz, .bars = {10, 12}, .sound = {kVoice, 4, 3, 100}, .strokes = {1, 8}, .velocity = {80, 90}, .line = "0"},
    // Four stabs: table, flake, patches, day. A roll
    {.scene = kOdraz, .bars = {8, 9}, .sound = {kPiano, 4, 3, 100}, .strokes = {4, 16}, .velocity = {90, 90}, .line = kStabs},
    {.scene = kOdraz, .bars = {8, 9}, .sound = {kWood, 4, 3, 100}, .strokes = {4, 16}, .velocity = {90, 90}, .line = "D..."},
    {.scene = kOdraz, .bars = {8, 9}, .sound = {kGlassDrop, 5, 3, 100}, .strokes = {4, 16}, .velocity = {90, 90}, .line = ".F.."},
    {.scene = kOdraz, .bars = {8, 9}, .sound = {kPulse, 4, 3, 100}, .strokes = {4, 16}, .velocity = {90, 90}, .line = "..B."},
    {.scene = kOdraz, .bars = {8, 9}, .sound = {kVoice, 4, 3, 100}, .strokes = {4, 16}, .velocity = {90, 90}, .line = "...G"},
    {.scene = kOdraz, .bars = {9, 10}, .sound = {kBrush, 7, 1, 100}, .strokes = {16, 16}, .velocity = {30, 80}, .line = "a"},
    {.scene = kOdraz, .bars = {9, 10}, .sound = {kPiano, 4, 3, 100}, .strokes = {4, 16}, .velocity = {60, 90}, .line = "0"},
    {.scene = kOdraz, .bars = {8, 10}, .sound = {kPiano, 5, 1, 100}, .strokes = {4, 16}, .velocity = {90, 90}, .line = kStabs},
    {.scene = kOdraz, .bars = {8, 10}, .sound = {kRiser, 6, 1, 100}, .strokes = {1, 32}, .velocity = {50, 50}, .line = "a"},
    // The summit: the tune's first phrase in three octaves
    {.scene = kOdraz, .bars = {10, 12}, .sound = {kPiano, 5, 1, 60}, .strokes = {1, 4}, .velocity = {90, 90}, .line = kTune},
    {.scene = kOdraz, .bars = {10, 12}, .sound = {kPiano, 4, 1, 60}, .strokes = {1, 4}, .velocity = {90, 90}, .line = kTune},
    {.scene = kOdraz, .bars = {10, 12}, .sound = {kVoice, 5, 1, 60}, .strokes = {1, 4}, .velocity = {90, 90}, .line = kTune},
    {.scene = kOdraz, .bars = {10, 12}, .sound = {kVoice, 6, 1, 60}, .strokes = {1, 4}, .velocity = {50, 50}, .line = kTune},
    {.scene = kOdraz, .bars = {10, 12}, .sound = {kBrush, 7, 1, 100}, .strokes = {4, 16}, .velocity = {90, 90}, .line = ".a"},
    {.scene = kOdraz, .bars = {10, 12}, .sound = {kGlassDrop, 6, 1, 100}, .strokes = {16, 16}, .velocity = {40, 50}, .line = "42031"},
    // The strips go out: the scale backwards, bare. Em, A7, and D major from below
    {.scene = kOdraz, .bars = {12, 14}, .sound = {kPiano, 5, 1, 100}, .strokes = {4, 16}, .velocity = {70, 50}, .line = "dcbaGFED"},
    {.scene = kOdraz, .bars = {12, 16}, .sound = {kWind, 6, 1, 100}, .strokes = {1, 16}, .velocity = {10, 10}, .line = "0"},
    {.scene = kOdraz, .bars = {14, 16}, .sound = {kVoice, 4, 2, 100}, .strokes = {1, 16}, .velocity = {20, 20}, .line = "01"},
    {.scene = kOdraz, .bars = {14, 18}, .sound = {kBass, 2, 1, 0}, .strokes = {1, 16}, .velocity = {30, 60}, .line = "EADD"},
    {.scene = kOdraz, .bars = {16, 18}, .sound = {kPiano, 3, 1, 100}, .strokes = {4, 16}, .velocity = {40, 70}, .line = "DFadFadf"},
    {.scene = kOdraz, .bars = {16, 18}, .sound = {kPad, 3, 3, 100}, .strokes = {1, 32}, .velocity = {40, 40}, .line = "0"},
    {.scene = kOdraz, .bars = {17, 18}, .sound = {kVoice, 4, 1, 100}, .strokes = {1, 16}, .velocity = {40, 40}, .line = "F"},
    {.scene = kOdraz, .bars = {16, 17}, .sound = {kGlassDrop, 5, 1, 100, -60}, .strokes = {8, 16}, .velocity = {50, 50}, .line = kCell},
    {.scene = kOdraz, .bars = {16, 17}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {30, 30}, .line = kCellAnswer},

    // The cell inverted; the letters go out; an answer without its ping
    {.scene = kCredits, .bars = {0, 1}, .sound = {kPiano, 2, 2, 150}, .strokes = {1, 16}, .velocity = {60, 60}, .line = "0"},
    {.scene = kCredits, .bars = {0, 4}, .sound = {kPad, 4, 3, 150}, .strokes = {1, 64}, .velocity = {30, 30}, .line = "0"},
    {.scene = kCredits, .bars = {0, 6}, .sound = {kWind, 7, 1, 100}, .strokes = {1, 32}, .velocity = {12, 12}, .line = "2"},
    {.scene = kCredits, .bars = {1, 3}, .sound = {kGlassDrop, 5, 1, 150}, .strokes = {2, 16}, .velocity = {60, 50}, .line = "aEDA"},
    {.scene = kCredits, .bars = {3, 5}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {2, 16}, .velocity = {40, 30}, .line = "aEDA"},
    {.scene = kCredits, .bars = {4, 6}, .sound = {kPiano, 5, 1, 150}, .strokes = {4, 16}, .velocity = {30, 20}, .line = "daEDaGED"},
    {.scene = kCredits, .bars = {6, 8}, .sound = {kGlassDrop, 5, 1, 150, 60}, .strokes = {8, 16}, .velocity = {20, 10}, .line = "..daEDaG........"},
};

// Event; instrument, octave, tones at once, room, per cent to the left; velocity; tone.
static constexpr EventSound kEventSounds[] = {
    {kLightIsBorn, {kGlassDrop, 5, 1, 150}, 50, 'a'},
    {kLightGrows, {kGlassDrop, 5, 1, 150}, 50, 'e'},
    {kRimLightWakes, {kGlassDrop, 6, 1, 150}, 40, 'E'},
    {kCausticFalls, {kGlassDrop, 6, 1, 150}, 60, 'a'},
    {kGlint, {kDrum, 1, 1, 150}, 90, 'a'},
    {kGlint, {kImpact, 2, 1, 150}, 40, 'D'},
    {kGlint, {kPiano, 3, 1, 150}, 60, 'D'},
    {kGlint, {kPiano, 3, 1, 150}, 60, 'a'},
    {kCopperFills, {kPiano, 3, 2, 150}, 70, '0'},
    {kDarkBall, {kPiano, 2, 1, 150}, 70, '0'},
    {kBareBall, {kBass, 2, 1, 150}, 60, 'D'},
    {kGeneration1, {kPiano, 3, 2, 150}, 60, '0'},
    {kGeneration1, {kDrum, 1, 1, 150}, 90, 'a'},
    {kGeneration1, {kImpact, 4, 1, 150}, 30, 'D'},
    {kGeneration2, {kPiano, 3, 4, 150}, 60, '0'},
    {kGeneration2, {kDrum, 1, 1, 150}, 90, 'a'},
    {kGeneration3, {kPiano, 3, 5, 150}, 70, '0'},
    {kGeneration3, {kDrum, 1, 1, 150}, 90, 'a'},
    {kGateOpens, {kImpact, 4, 1, 150}, 40, 'D'},
    {kHemicubeRises, {kGlassDrop, 4, 1, 40}, 60, '0'},
    {kHemicubeOpens, {kGlassDrop, 5, 1, 40}, 60, '0'},
    {kPatchTakesColour, {kGlassDrop, 5, 2, 40}, 60, '2'},
    {kHemicubeCloses, {kGlassDrop, 4, 1, 40}, 60, '0'},
    {kDirectLight, {kPiano, 3, 2, 150}, 90, '0'},
    {kDirectLight, {kDrum, 1, 1, 150}, 80, 'a'},
    {kDirectLight, {kImpact, 2, 1, 150}, 60, 'D'},
    {kBounce1, {kPiano, 3, 3, 150}, 70, '0'},
    {kBounce1, {kDrum, 1, 1, 150}, 90, 'a'},
    {kBounce1, {kImpact, 3, 1, 150}, 30, 'D'},
    {kBounce2, {kPiano, 3, 4, 150}, 80, '0'},
    {kBounce2, {kDrum, 1, 1, 150}, 90, 'a'},
    {kBounce3, {kPiano, 3, 4, 150}, 80, '0'},
    {kBounce3, {kDrum, 1, 1, 150}, 90, 'a'},
    {kPatchesMelt, {kPiano, 3, 3, 150}, 50, '0'},
    {kBallRollsIn, {kPiano, 3, 2, 150}, 50, '0'},
    {kNoonStrikes, {kPiano, 3, 3, 150}, 50, '0'},
    {kLamp1, {kPiano, 5, 1, 150}, 70, 'A'},
    {kLamp2, {kPiano, 5, 1, 150}, 70, 'D'},
    {kLamp3, {kPiano, 5, 1, 150}, 60, 'E'},
    {kLamp3Dies, {kGlassDrop, 5, 1, 150}, 60, 'E'},
    {kLamp2Dies, {kGlassDrop, 5, 1, 150}, 60, 'D'},
    {kLamp1Dies, {kGlassDrop, 5, 1, 150}, 60, 'A'},
    {kCrown, {kGlassDrop, 5, 2, 150}, 80, '2'},
    {kCrown, {kImpact, 2, 1, 150}, 20, 'D'},
    {kStrip1, {kDrum, 1, 1, 150}, 60, 'a'},
    {kStrip1, {kImpact, 2, 1, 150}, 40, 'D'},
    {kStripsPlay, {kImpact, 3, 1, 150}, 40, 'D'},
    {kBall1, {kPiano, 3, 2, 150}, 60, '0'},
    {kBall1, {kImpact, 2, 1, 150}, 60, 'D'},
    {kBall2, {kGlassDrop, 5, 1, 150, -60}, 90, 'A'},
    {kBall3, {kGlassDrop, 5, 1, 150, -60}, 90, 'D'},
    {kBall4, {kGlassDrop, 5, 1, 150, -60}, 90, 'E'},
    {kBall5, {kGlassDrop, 5, 1, 150, -60}, 90, 'a'},
    {kToneUp, {kImpact, 4, 1, 150}, 30, 'D'},
    {kLampLights, {kPiano, 4, 1, 150}, 80, '0'},
    {kRecall, {kImpact, 4, 1, 150}, 30, 'D'},
    {kSummit, {kImpact, 4, 1, 150}, 30, 'D'},
    {kWordShines, {kGlassDrop, 6, 1, 150}, 60, 'D'},
    {kLine1, {kGlassDrop, 6, 1, 150}, 40, 'D'},
    {kLine2, {kGlassDrop, 6, 1, 150}, 40, 'a'},
    {kLine3, {kGlassDrop, 6, 1, 150}, 40, 'F'},
    {kLastAnswer, {kGlassDrop, 5, 1, 50, 60}, 30, 'D'},
};
// clang-format on

// Returns by how many semitones a bar is transposed.
static int semitonesUpAt(int scene, int bar) {
    return scene == kOdraz && bar >= kEvents[kToneUp].row / 16 && bar < kEvents[kWordIsFound].row / 16 ? 2
                                                                                                       : 0;
}

// Returns the crossfeed in per cent (mixer.h). The sound is narrow before direct light, widest in the finale.
static int crossfeedAt(int scene, int bar) {
    // Rows in the enum's order
    static constexpr int8_t kCrossfeed[kSceneCount] = {
        [kPoint] = 15, [kTable] = 25, [kFlake] = 12,  [kPatches] = 16,
        [kHall] = 13,  [kOdraz] = 6,  [kCredits] = 10};
    return scene == kPatches && bar < kEvents[kDirectLight].row / 16 ? 35 : kCrossfeed[scene];
}

} // namespace odraz
