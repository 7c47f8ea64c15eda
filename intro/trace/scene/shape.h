// The shapes of a scene, all described in a local frame: local = frame * (world - centre).
//
//   Sphere    radius half.x about the origin (half.y = half.z = half.x)
//   Plane     the local plane y = 0; unbounded
//   Box       |x| <= half.x, |y| <= half.y, |z| <= half.z
//   Cylinder  x^2 + z^2 <= half.x^2, |y| <= half.y, capped at both ends
//   Polygon   in the local plane y = 0, bounded by a simple closed outline of (x, z) points, convex or not
//   Rect      in the local plane y = 0, |x| <= half.x, |z| <= half.z; met only from where y > 0
//   Triangle  x >= 0, z >= 0, x + z <= 1 in the local plane y = 0, whose frame is askew; met as a Rect is
//
// Spheres, boxes and cylinders are solid (glass has an inside); planes and polygons are seen from both sides,
// rectangles and triangles from one: what is walled in by them can be looked into from outside. Their solid
// textures lie in world coordinates, so that those of neighbours join.
// Sizes from 1e-4 to 1e6 and distances up to kFar are meant to work; nothing beyond kFar is ever hit.
#pragma once

#include "base/vec3.h"

namespace odraz {

inline constexpr float kFar = 1e9f;

enum class ShapeKind : uint8_t { Sphere, Plane, Box, Cylinder, Polygon, Rect, Triangle };

struct Shape {
    ShapeKind kind;
    uint8_t material;     // index into Scene::materials
    uint16_t firstVertex; // polygons: the outline in Scene::outline, two floats a point
    uint16_t vertexCount; //
    Vec3 centre;          // world
    Vec3 half;            // see above; positive
    Mat3 frame;           // a rotation; but see Triangle
    bool aligned;         // the frame is the world's; Scene::finish() sees to it
    Vec3 textureShift;    // added to local coordinates before texturing: no two balls cut from one place
    int chart = -1;       // index into the lightmap's charts, -1: lit by ambient light
};

inline Shape sphere(Vec3 centre, float radius, int material) {
    return {ShapeKind::Sphere,        (uint8_t)material, 0,    0,  centre,
            {radius, radius, radius}, kIdentity,         true, {}, -1};
}
// Through `point`, facing up.
inline Shape plane(Vec3 point, int material) {
    return {ShapeKind::Plane, (uint8_t)material, 0, 0, point, {}, kIdentity, true, {}, -1};
}
inline Shape box(Vec3 centre, Vec3 half, int material) {
    return {ShapeKind::Box, (uint8_t)material, 0, 0, centre, half, kIdentity, true, {}, -1};
}
// Upright, about its middle.
inline Shape cylinder(Vec3 middle, float radius, float halfHeight, int material) {
    return {ShapeKind::Cylinder,          (uint8_t)material, 0,    0,  middle,
            {radius, halfHeight, radius}, kIdentity,         true, {}, -1};
}
// With sides u and v from one corner, facing u x v; n is that direction.
Shape triangle(Vec3 corner, Vec3 u, Vec3 v, Vec3 n);

struct Bounds {
    Vec3 lo, hi;
};

} // namespace odraz
