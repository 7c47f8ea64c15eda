// What happens in the film, and when: a table of rows that scenes, music and tests read, so that each stands
// once.
//
// Rows count from the start of the scene's story, as its cameras' keys do (8 a second, 16 a bar): a scene
// that moves takes its events with it. What is marked as heard has a sound in music.h, which begins on that
// very row.
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

// The rows of the big hits. The half beat before each is silent.
inline constexpr EventId kHits[] = {kBallLands};

} // namespace odraz
