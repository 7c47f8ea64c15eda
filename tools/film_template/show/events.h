// The events of the film: a table of their rows, which scenes, music and tests read.
//
// Rows count from the start of the scene's story, as in its cameras' keys (8 a second, 16 a bar). So if a
// scene moves, its events move with it. A heard event has a sound in music.h, which begins on its row.
#pragma once

#include "base/rows.h"
#include "show/event.h"

namespace odraz {

enum SceneId : uint8_t { kStage, kSceneCount };

enum EventId : uint8_t { kBallLands, kBallLandsAgain, kWordComes, kEventCount };

inline constexpr Event kEvents[] = {
    {kBallLands, kStage, 16, true},
    {kBallLandsAgain, kStage, 24, true},
    {kWordComes, kStage, 28, false},
};
static_assert(inOrder(kEvents, &Event::id, kEventCount), "a row for every event, in the enum's order");

// The row of an event, for keys.
consteval float rowOf(EventId event) { return kEvents[event].row; }

// The events before which all is silent, and for how many rows: two are half a beat.
inline constexpr Silence kSilences[] = {{kEvents[kBallLands], 2}};

} // namespace odraz
