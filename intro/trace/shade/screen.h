// Balls before a lamp that is a ball itself: soft shadows, and the caustics of glass.
//
// Seen from a place, lamp and ball are discs; what one hides of the other is their overlap, within 0.036 for
// all sizes. Glass gathers what it takes: rays near the axis meet n / (2 (n - 1)) radii behind the middle,
// others sooner, so that there is a narrow core with wide skirts. Within a radius y, in radii of the ball,
// lies y^2 / (y^2 + s^2) of the light, within 0.1 of what rays find that are refracted twice from 1.25 radii
// behind the middle on, and no more than passes, weakened by the tint.
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
