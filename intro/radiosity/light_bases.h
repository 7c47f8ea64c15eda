// Light bases: a model is solved for each of these lights alone. Light is linear, so the light of any moment
// is a weighted sum of them.
//
// Their order is the same everywhere: skies, then suns, then lamps. BasisOrder gives the number of a basis.
#pragma once

#include "base/vec3.h"

namespace odraz {

inline constexpr int kMaxSkies = 32, kMaxSuns = 32, kMaxLamps = 16,
                     kMaxBases = kMaxSkies + kMaxSuns + kMaxLamps;

// How many bases there are of each kind; the number of each basis follows from that.
struct BasisOrder {
    int skyCount, sunCount, lampCount;

    constexpr int firstSun() const { return skyCount; }
    constexpr int firstLamp() const { return skyCount + sunCount; }
    constexpr int count() const { return firstLamp() + lampCount; }
    constexpr bool fit() const {
        return skyCount <= kMaxSkies && sunCount <= kMaxSuns && lampCount <= kMaxLamps;
    }
};

// Something that shines with radiance 1: a ball, or if radius is 0 the lit side of a chart.
struct Lamp {
    Vec3 centre;
    float radius;
    int chart;
};

// Bases have one colour; the picture multiplies in the colour later. Callers that set the counts must check
// that they fit().
struct LightBases : BasisOrder {
    // Skies stand in all windows. They are functions of the unit direction and may be negative, except the
    // first, whose light decides how far that of the others is extrapolated
    void (*sky)(const void *skies, const Vec3x8 &d, Float8 *radiance);
    const void *skies;
    Vec3 suns[kMaxSuns]; // directions in world space; their light is parallel; irradiance / pi is 1 on what
                         // faces them
    Lamp lamps[kMaxLamps];
};

} // namespace odraz
