// Direct light on texels: from the sky through windows, from the sun, from lamps. Shadow rays are the
// tracer's.
//
// Every texel is looked at from four places, those that can be seen. Areas that shine are divided into cells;
// from afar each place takes every fourth, so that penumbrae are even and need no random numbers, and a cell
// counts as a disc, cos cos' A / (pi r^2 + A) (Wallace, Elmquist and Haines, "A Ray Tracing Algorithm for
// Progressive Radiosity", SIGGRAPH 1989). From near it takes all of them, by Lambert's exact formula. Balls
// count by their exact form factor. Visibility is one shadow ray to each cell, and one from each place to a
// ball.
#pragma once

#include "base/parallel.h"
#include "base/progress.h"
#include "radiosity/visible.h"

namespace odraz {

inline constexpr int kMaxSkies = 32, kMaxSuns = 32, kMaxLamps = 16,
                     kMaxBases = kMaxSkies + kMaxSuns + kMaxLamps, kMaxLampCells = 256;

// Something that shines with radiance 1: a ball, or where radius is 0 a chart, on its lit side.
struct Lamp {
    Vec3 centre;
    float radius;
    int chart;
};

// A facet that shines in a colour of its own: red, green and blue count to the first three skies.
struct Glow {
    int facet;
    int cells; // 1 .. kMaxLampCells
    Rgb radiance;
};

// All of it has one colour, but for glows: what is linear in it has its colour later. A basis is one of the
// skies, then one of the suns, then one of the lamps.
struct Lights {
    // Skies stand in all windows: functions of the unit direction that may be negative, but for the first
    // one, which tells where light from the windows changes. Null: there is none, and three skies are the
    // red, green and blue of the glows
    void (*sky)(const void *skies, const Vec3x8 &d, Float8 *radiance);
    const void *skies;
    const Glow *glows;
    int skyCount, sunCount, lampCount, glowCount;
    Vec3 suns[kMaxSuns]; // world; so far away that their light is parallel; irradiance / pi of 1 on what
                         // faces them
    Lamp lamps[kMaxLamps];

    int firstLamp() const { return skyCount + sunCount; }
    int bases() const { return firstLamp() + lampCount; }
    // Whoever counts them himself must not have too many
    bool fit() const { return skyCount <= kMaxSkies && sunCount <= kMaxSuns && lampCount <= kMaxLamps; }
    int functions() const { return sky ? skyCount : 0; }
};

// Adds up light for the fresh texels: direct[k] is a plane, the share of basis k that arrives. The scene
// holds the posed model, finished.
void findDirectLight(const Model &model, const Scene &scene, const Lights &lights, Workers &workers,
                     float *const *direct, const Progress &progress);

} // namespace odraz
