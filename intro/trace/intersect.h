// Rays against shapes, eight rays at a time.
//
// Directions have unit length. A hit counts at t > 0 and t < kFar; origins on surfaces are moved off them by
// the caller (offsetOrigin). Solid shapes are met from inside too, at their far side. The forms are chosen
// for floats: a sphere is judged by the perpendicular distance from its centre to the ray (Haines, Guenther
// and Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019), the
// others as intersections of intervals in their local frames.
#pragma once

#include "trace/scene.h"

namespace odraz {

struct Ray8 {
    Vec3x8 o, d;
};

struct Hit8 {
    Float8 t;   // kInfinity where nothing is hit
    Int8 shape; // index into Scene::shapes, -1 where nothing is hit
};

// The nearest hit of each ray. Lanes outside `active` cost nothing where whole boxes can be skipped; their
// result is undefined.
Hit8 intersect(const Scene &scene, const Ray8 &ray, Int8 active);

// What share of light passes along each active ray up to tMax: 0 behind anything opaque, tinted by glass.
// `blocker` is an opaque shape to try first, or -1; it becomes the last one met. It changes the speed only.
Rgb8 transmittance(const Scene &scene, const Ray8 &ray, Float8 tMax, Int8 active, int &blocker);

// Distance to one shape, kInfinity where it is missed. `wholePlane`: takes a polygon without its outline.
Float8 distance(const Scene &scene, const Shape &shape, const Ray8 &ray, bool wholePlane = false);

// The place that a ray meets.
struct Surface8 {
    Vec3x8 p;     // world, projected back onto the shape: its error depends on coordinates, not on t
    Vec3x8 n;     // outward unit normal
    Vec3x8 local; // p in the shape's frame; a rectangle's is the world's
    Int8 face;    // 0..6: which side of a box or cylinder
};
Surface8 surfaceAt(const Shape &shape, const Ray8 &ray, Float8 t);

// An origin that lies surely on the side of the surface to which `side` points (+1 along n, -1 against it).
Vec3x8 offsetOrigin(const Shape &shape, const Surface8 &surface, Float8 side);

} // namespace odraz
