// Finds what rays hit in a scene, and how much light passes along them.
//
// Coherent packets of eight rays traverse the tree together. In other packets each ray traverses it alone,
// tested against eight boxes or balls at once. The result is the same, only the time differs: at equal
// distances, the shape that was added first is hit. See beam.h for rays that share an origin.
#pragma once

#include "trace/scene/scene.h"
#include "trace/scene/surface.h"

namespace odraz {

struct Hit8 {
    Float8 t;   // kInfinity where nothing is hit
    Int8 shape; // index into Scene::shapes, -1 where nothing is hit
};

ODRAZ_INLINE void takeNearer(Hit8 &hit, Float8 t, int shape) {
    Int8 nearer = (t < hit.t) | ((t == hit.t) & (shape < hit.shape));
    hit.t = select(nearer, t, hit.t);
    hit.shape = select(nearer, broadcast(shape), hit.shape);
}

// Dims the light of the rays that hit a shape on their way from a light, and clears the lanes of `active`
// that it stops.
void dim(const Scene &scene, const Shape &shape, Int8 hit, Rgb8 &share, Int8 &active);

// The nearest hit of each ray. Lanes outside `active` never cause a box to be visited; their result is
// undefined.
Hit8 intersect(const Scene &scene, const Ray8 &ray, Int8 active);

// The share of light that passes along each active ray up to the distance tMax: 0 behind anything opaque,
// tinted by glass. In each lane the shape `own` is left out, because it cannot be in the way (-1: none).
// `noBalls` leaves out all balls.
Rgb8 transmittance(const Scene &scene, const Ray8 &ray, Float8 tMax, Int8 active, Int8 own,
                   bool noBalls = false);

} // namespace odraz
