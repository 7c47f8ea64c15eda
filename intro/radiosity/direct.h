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
#include "radiosity/elements.h"

namespace odraz {

inline constexpr int kMaxSkies = 12, kMaxLamps = 16, kMaxBases = kMaxSkies + kMaxLamps, kMaxLampCells = 256;

// A sky that stands in all windows, and the sun, a point so far away that its light is parallel.
struct SkyKey {
    Sky sky;
    Vec3 sunAt;   // world
    Rgb sunlight; // irradiance / pi on what faces it
};

// Something that shines with radiance 1: a ball, or where radius is 0 a chart, on its lit side.
struct Lamp {
    Vec3 centre;
    float radius;
    int chart;
};

// A facet that shines whatever the sky; it belongs to sky 0.
struct Glow {
    int facet;
    int cells; // 1 .. kMaxLampCells
    Rgb radiance;
};

struct Lights {
    SkyKey skies[kMaxSkies];
    Lamp lamps[kMaxLamps];
    const Glow *glows;
    int skyCount, lampCount, glowCount;

    int bases() const { return skyCount + lampCount; } // skies first
};

// Adds up light for the fresh texels, in planes: sky[k] gets what comes from sky k through the windows (red,
// green, blue), single[k] the share of sky k's sunlight, then those of the lamps' radiances. The scene holds
// the posed model, finished.
void findDirectLight(const Model &model, const Scene &scene, const Lights &lights, Workers &workers,
                     float *const (*sky)[3], float *const *single, const Progress &progress);

} // namespace odraz
