// The hall's shape: where its walls, columns, beams, stair and lamps stand.
#pragma once

#include "show/hall.h"

namespace odraz {

// Materials by number; each strip and each lantern has its own, because each has its own brightness.
enum HallPart {
    kFloor,
    kWall,
    kWarm,
    kShaft,
    kBlock,
    kBeamX,
    kBeamZ,
    kStep,
    kLantern,
    kStrip = kLantern + kLanterns
};
static_assert(kStrip + kStrips == kHallMaterials);

inline constexpr float kLanternRadius = 0.15f;

// Adds charts and facets to its empty model, whose names it notes, and its lamps: lanterns, then strips.
void buildHall(Hall &hall);

} // namespace odraz
