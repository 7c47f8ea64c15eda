// Light bases: a model is solved for each of these lights alone. Light is linear, so the light at any time is
// a weighted sum of them.
//
// Their order is the same everywhere: skies, suns, lamps. BasisOrder has the index of each.
#pragma once

#include "base/vec3.h"

namespace odraz {

inline constexpr int kMaxSkies = 32, kMaxSuns = 32, kMaxLamps = 16,
                     kMaxBases = kMaxSkies + kMaxSuns + kMaxLamps;

// The number of bases of each kind, from which each basis's index follows.
struct BasisOrder {
    int skyCount, sunCount, lampCount;

    constexpr int firstSun() const { return skyCount; }
    constexpr int firstLamp() const { return skyCount + sunCount; }
    constexpr int count() const { return firstLamp() + lampCount; }
    constexpr bool withinLimits() const {
        return skyCount <= kMaxSkies && sunCount <= kMaxSuns && lampCount <= kMaxLamps;
    }
};

// A light source with radiance 1: a ball, or a chart's front if the radius is 0.
struct Lamp {
    Vec3 centre;
    float radius;
    int chart;
};

// Bases are white; pictures multiply them by their colours. Whoever sets the counts checks withinLimits().
struct LightBases : BasisOrder {
    // Skies shine through all windows. They are functions of the unit direction and may be negative, except
    // the first, whose light limits the extrapolation of the others (spread.h)
    void (*sky)(const void *skies, const Vec3x8 &d, Float8 *radiance);
    const void *skies;
    // Positions in world space, far away. Irradiance / pi is 1 on a surface that faces the sun
    Vec3 suns[kMaxSuns];
    Lamp lamps[kMaxLamps];
};

} // namespace odraz
