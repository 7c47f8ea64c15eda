// This film has no room whose light is solved while it loads, so these functions do nothing.
//
// A film with such a room defines Hall as a Room (transfer/room.h) and uses its solveRoom() and kRoomBytes.
// It defines the first two functions, with its model and its lights. Scenes in the room have .needsHall in
// film.cpp.
#pragma once

#include "radiosity/radiosity.h"

namespace odraz {

struct Hall {
    bool solved() const { return false; }
};
inline constexpr size_t kRoomBytes = 0;

inline void prepareHall(Hall &, Scene &) {}
inline Hall hallSettings(const Hall &hall) { return hall; }
inline const char *solveRoom(Hall &, Scene &, const Hall &, const SolverHost &) { return nullptr; }

} // namespace odraz
