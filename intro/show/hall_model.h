// The hall's geometry: walls, columns, beams, stair and lamps.
#pragma once

#include "show/hall.h"

namespace odraz {

// Indices of materials. Each strip and each lantern has its own, because each has its own brightness.
enum HallPart {
    kFloor,
    kWall,
    kWarm,
    kShaft,
    kBlock,
    kBeamX,
    kBeamZ,
    kStep,
    kSand,
    kLantern,
    kStrip = kLantern + kLanterns
};
static_assert(kStrip + kStrips == kHallMaterials);

inline constexpr float kX = 4.5f, kY = 6.5f, kZ = 9; // half width, height, half length
// Windows in the wall x = -kX. kWindow: half width; kDeep: depth; kWindows: centres in z
inline constexpr float kSill = 1.75f, kLintel = 5.25f, kWindow = 0.625f, kDeep = 0.5f;
inline constexpr float kWindows[] = {-6.5f, -3.25f, 0, 3.25f, 6.5f};
inline constexpr float kColumnX = 2.25f, kColumnRadius = 0.32f,
                       kColumns[] = {-4.875f, -1.625f, 1.625f, 4.875f};
inline constexpr float kLanternRadius = 0.15f, kLanternSpacing = 3.25f;

// Fills the hall's empty model, sets `floor` and `vault`, and adds the lamps: lanterns, then strips.
void buildHall(Hall &hall);

} // namespace odraz
