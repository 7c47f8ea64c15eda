// Balls before a lamp that is a ball itself: soft shadows, and the caustics of glass.
//
// Seen from a place, lamp and ball are discs; what one hides of the other is their overlap, within 0.036 for
// all sizes. Glass gathers what it takes: paraxially all
// rays meet n / (2 (n - 1)) radii behind the middle; before and behind, and because rays far from the axis
// meet sooner, they fill a spot. Its light sums to what the ball takes, weakened by its tint.
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

// Those that may stand between a light and places in a box.
struct Screens {
    int count;
    uint8_t ball[kMaxOccluders]; // indices of Scene::occluder
};
void findScreens(const Scene &scene, const Light &light, const Bounds &box, Screens &found);

// What share of a light's arrives at places, which lie `far` from it in direction l (unit); more than 1 in
// caustics. In each lane the shape `own` is left out; -1: none.
Rgb8 passScreens(const Scene &scene, const Screens &screens, const Light &light, const Vec3x8 &p,
                 const Vec3x8 &l, Float8 far, Int8 own);

} // namespace odraz
