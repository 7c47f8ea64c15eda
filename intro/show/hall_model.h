// The hall's shape: where its walls, columns, beams, stair and lamps stand.
#pragma once

#include "show/hall.h"

namespace odraz {

// Materials by number; each strip and each lantern has its own, because each has its own brightness.
enum HallPart {
    kFloor,
    kPlaster,
    kWarm,
    kShaft,
    kBlock,
    kBeamX,
    kBeamZ,
    kStep,
    kLantern,
    kStrip = kLantern + kLanterns
};

inline constexpr float kLanternRadius = 0.15f;

// Adds charts and facets to an empty model, the floor first, then the five bays of the ceiling; and the
// lamps: lanterns, then strips.
void buildHall(Model &model, Lights &lights);

} // namespace odraz
