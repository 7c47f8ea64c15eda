// Soft shadows of balls in the light of a lamp that is a ball too, and the caustics of glass balls.
//
// Seen from a place, lamp and ball are discs. Their overlap is the hidden share of the lamp; the formula is
// within 0.036 of it for all sizes. A glass ball focuses the light that it takes. Rays near the axis meet n /
// (2 (n - 1)) radii behind its middle, the others sooner, so the light has a narrow core and wide skirts. The
// share of the light within a radius y, in radii of the ball, is y^2 / (y^2 + s^2). From 1.25 radii behind
// the middle on, this is within 0.1 of the result of rays that are refracted twice. The caustic holds no more
// light than passes the ball, weakened by the tint.
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

// The balls that may stand between a light and places in a box.
struct Blockers {
    int count;
    uint8_t ball[kMaxOccluders]; // indices of Scene::occluder
};
void findBlockers(const Scene &scene, const Light &light, const Bounds &box, Blockers &found);

// The share of a light that arrives at places p; more than 1 in caustics. The light lies `far` from p in
// direction l (unit). In each lane the shape `own` is left out; -1: none.
Rgb8 softShadow(const Scene &scene, const Blockers &blockers, const Light &light, const Vec3x8 &p,
                const Vec3x8 &l, Float8 far, Int8 own);

} // namespace odraz
