// The film's music: a chord for each bar, parts that play the chords, and the sounds of events. Only
// score.cpp includes it.
#pragma once

#include "show/length.h"
#include "show/score.h"

namespace odraz {

// clang-format off
constexpr const char *const kChords[kSceneCount] = { // rows in the enum's order
    [kStage] = "DBADD",
};

// .bars: from, to. .sound: instrument, octave, tones at once, reverberation in per cent. .strokes: number, rows.
// .velocity: at the start, at the end.
static constexpr Part kParts[] = {
    {.scene = kStage, .bars = {0, 4}, .sound = {kPad, 3, 4, 100}, .strokes = {1, 16}, .velocity = {70, 90}, .line = "0"},
    {.scene = kStage, .bars = {0, 4}, .sound = {kPiano, 2, 1, 60}, .strokes = {1, 16}, .velocity = {80, 90}, .line = "0"},
    {.scene = kStage, .bars = {0, 3}, .sound = {kPiano, 4, 1, 100}, .strokes = {8, 16}, .velocity = {40, 65}, .line = "02143524"},
    {.scene = kStage, .bars = {0, 4}, .sound = {kPiano, 5, 1, 120}, .strokes = {1, 4}, .velocity = {80, 100}, .line = "D-aGF-EDE-CED---"},
};

// Columns: event; {instrument, octave, tones at once, reverberation in per cent}; velocity; tone.
static constexpr EventSound kEventSounds[] = {
    {kBallLands, {kDrum, 1, 1, 120}, 90, 'a'},
    {kBallLandsAgain, {kDrum, 1, 1, 120}, 50, 'a'},
};
// clang-format on

// The level of each bar of the film in dB, applied after the compressor.
static constexpr int8_t kLevels[(int)kEndRow / 16] = {};

// Returns by how many semitones a bar of a scene is transposed.
static int semitonesUpAt(int, int) { return 0; }

// Returns the share of each channel that the other gets, in per cent. A smaller share sounds wider.
static int crossfeedAt(int, int) { return 12; }

} // namespace odraz
