// Soft shadows of balls in the light of a lamp that is a ball too, and the caustics of glass balls.
//
// From a lit point, lamp and ball are seen as discs. Their overlap is the hidden share of the lamp; the
// formula is within 0.036 of it for all sizes.
//
// A glass ball focuses the light that it blocks. Rays near the axis meet n / (2 (n - 1)) radii beyond its
// centre, other rays sooner. So before that focus the rays overlap inside a horn, whose radius shrinks to a
// cusp, like the 3/2 power of the distance to the focus. Its rim has the 1 / sqrt singularity of a fold
// caustic. For u = (distance from the axis)^2 and h = (the horn's radius)^2, the density of light is the real
// part of 1 / sqrt(h - u + bi): a fold blurred by b, or a core with soft edges where h = 0. It is divided by
// its integral, so that it holds the light that passes the ball, weakened by the tint. At all distances
// behind the ball, the share of light within a given radius differs by less than 0.1 from exact refraction.
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

// The balls that may be between a light and points in a box.
struct Blockers {
    int count;
    uint8_t ball[kMaxOccluders]; // indices of Scene::occluder
};
void findBlockers(const Scene &scene, const Light &light, const Bounds &box, Blockers &found);

// The share of a light that arrives at points p; more than 1 in caustics. The light is at `distance` from p
// in direction l (unit). In each lane the shape with index `ignored` does not count (-1: all count).
Rgb8 softShadow(const Scene &scene, const Blockers &blockers, const Light &light, const Vec3x8 &p,
                const Vec3x8 &l, Float8 distance, Int8 ignored);

} // namespace odraz
