// No scene of this film plays in a room whose light is solved while it loads, so there is nothing to prepare.
//
// A film that has one defines Hall as a Room (transfer/room.h), whose solveRoom() and kRoomBytes it uses, and
// the first two functions with its model and its lights. Scenes that play there have .needsHall in film.cpp.
#pragma once

#include "base/arena.h"
#include "base/gl.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "trace/scene/scene.h"

namespace odraz {

struct Hall {};
inline constexpr size_t kRoomBytes = 0;

inline void prepareHall(Hall &, Scene &) {}
inline Hall hallSettings(const Hall &hall) { return hall; }
inline const char *solveRoom(Hall &, Scene &, const Hall &, const Gl &, Arena &, Workers &,
                             const Progress &) {
    return nullptr;
}
inline void clearScratch(Hall &) {}

} // namespace odraz
