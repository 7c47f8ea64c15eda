// Finds what rays hit in a scene, and how much light passes along them.
//
// Coherent packets of eight rays traverse the tree together. In other packets each ray traverses it alone,
// tested against eight boxes or balls at once. Both ways give the same result: at equal distances, the shape
// that was added first is hit. See beam.h for rays that share an origin.
#pragma once

#include "trace/scene/scene.h"
#include "trace/scene/surface.h"

namespace odraz {

struct Hit8 {
    Float8 t;   // kInfinity where nothing is hit
    Int8 shape; // index into Scene::shapes, -1 where nothing is hit
};

ODRAZ_INLINE void updateNearest(Hit8 &hit, Float8 t, int shape) {
    Int8 nearer = (t < hit.t) | ((t == hit.t) & (shape < hit.shape));
    hit.t = select(nearer, t, hit.t);
    hit.shape = select(nearer, broadcast(shape), hit.shape);
}

// For shadow rays that hit a shape: multiplies `share` by what the shape transmits, and clears their lanes in
// `active` if it transmits nothing.
void dim(const Scene &scene, const Shape &shape, Int8 hit, Rgb8 &share, Int8 &active);

// The nearest hit of each ray. Lanes outside `active` cause no box to be visited; their result is undefined.
Hit8 intersect(const Scene &scene, const Ray8 &ray, Int8 active);

// The share of light that passes along each active ray up to the distance tMax: 0 if a shape there is opaque,
// tinted by glass. Each lane ignores the shape with index `ignored` (-1: none), and with `noBalls` all balls.
Rgb8 transmittance(const Scene &scene, const Ray8 &ray, Float8 tMax, Int8 active, Int8 ignored,
                   bool noBalls = false);

} // namespace odraz
