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
    kSand,
    kLantern,
    kStrip = kLantern + kLanterns
};
static_assert(kStrip + kStrips == kHallMaterials);

inline constexpr float kX = 4.5f, kY = 6.5f, kZ = 9; // half width, height, half length
// Windows, in the wall x = -kX: half width, middles in z
inline constexpr float kSill = 1.75f, kLintel = 5.25f, kWindow = 0.625f, kDeep = 0.5f;
inline constexpr float kWindows[] = {-6.5f, -3.25f, 0, 3.25f, 6.5f};
inline constexpr float kColumnX = 2.25f, kColumnRadius = 0.32f,
                       kColumns[] = {-4.875f, -1.625f, 1.625f, 4.875f};
inline constexpr float kLanternRadius = 0.15f, kLanternsApart = 3.25f;

// Fills the hall's empty model, keeps the charts that Hall names, and adds the lamps: lanterns, then strips.
void buildHall(Hall &hall);

} // namespace odraz
