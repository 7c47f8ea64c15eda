// The film's music: chords by the bar, parts that play them, and the sounds of events. For score.cpp alone,
// which plays it.
#pragma once

#include "show/score.h"

namespace odraz {

// clang-format off
constexpr const char *const kChords[] = {
    [kStage] = "DBADD",
};

// Scene, bars from and to; instrument, octave, tones at once, room; strokes in rows; velocity at the start and
// at the end; line.
static constexpr Part kParts[] = {
    {kStage, 0, 4, {kPad, 3, 4, 100}, 1, 16, 70, 90, "0"},
    {kStage, 0, 4, {kPiano, 2, 1, 60}, 1, 16, 80, 90, "0"},
    {kStage, 0, 3, {kPiano, 4, 1, 100}, 8, 16, 40, 65, "02143524"},
    {kStage, 0, 4, {kPiano, 5, 1, 120}, 1, 4, 80, 100, "D-aGF-EDE-CED---"},
};

// Event; instrument, octave, tones at once, room; velocity; tone.
static constexpr EventSound kEventSounds[] = {
    {kBallLands, {kDrum, 1, 1, 120}, 90, 'a'},
    {kBallLandsAgain, {kDrum, 1, 1, 120}, 50, 'a'},
};
// clang-format on

// The share of each side that the other takes, per cent: less is wider.
static int narrowAt(int, int) { return 12; }

} // namespace odraz
