// Soft shadows of balls in the light of a lamp that is a ball too, and the caustics of glass balls.
//
// Seen from a place, lamp and ball are discs. Their overlap is the hidden share of the lamp; the formula is
// within 0.036 of it for all sizes.
//
// A glass ball focuses the light that it takes. Rays near the axis meet n / (2 (n - 1)) radii behind its
// middle, the others sooner, so before that focus they overlap within a horn: its radius shrinks with the
// power 3/2 of the way that is left, to a cusp, and its rim is bright as 1 / sqrt is, like every fold of
// light. We take u = y^2 from the axis and h = (the horn's radius)^2: the density is the real part of
// 1 / sqrt(h - u + bi), which is the fold, blurred by b, and a core with skirts where h = 0. Divided by its
// integral it holds as much light as passes the ball, weakened by the tint. From the ball on, the light
// within a radius is within 0.1 of the result of rays that are refracted twice.
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
