// The shapes of a scene, all described in a local frame: local = frame * (world - centre).
//
//   Sphere    radius half.x about the origin (half.y = half.z = half.x)
//   Plane     the local plane y = 0; unbounded
//   Box       |x| <= half.x, |y| <= half.y, |z| <= half.z
//   Cylinder  x^2 + z^2 <= half.x^2, |y| <= half.y, capped at both ends
//   Rect      in the local plane y = 0, |x| <= half.x, |z| <= half.z
//
// Sizes from 1e-4 to 1e6 and distances up to kFar work; nothing beyond kFar is hit. A new kind must be convex
// (see isConvex()). It needs an enumerator, a row of kShapeTraits, and its cases in surface.cpp.
#pragma once

#include "base/rows.h"
#include "base/vec3.h"

namespace odraz {

inline constexpr float kFar = 1e9f;

enum class ShapeKind : uint8_t { Sphere, Plane, Box, Cylinder, Rect, Count };

// The properties of a kind that other code depends on.
struct ShapeTraits {
    ShapeKind kind;
    bool bounded : 1 = false; // has a box and is in the tree; unbounded shapes are tried by every ray
    bool solid : 1 = false;   // has an inside, of glass perhaps, from which rays also hit it; else it is flat
    bool oneSided : 1 = false; // hit only from y > 0, so that the eye can see into a room through its walls
    bool extents : 1 = false;  // `half` is its extent along the axes of its frame
    bool joins : 1 = false; // textured in world coordinates, so that textures continue on neighbouring shapes
};

inline constexpr ShapeTraits kShapeTraits[] = {
    {.kind = ShapeKind::Sphere, .bounded = true, .solid = true, .extents = true},
    {.kind = ShapeKind::Plane},
    {.kind = ShapeKind::Box, .bounded = true, .solid = true, .extents = true},
    {.kind = ShapeKind::Cylinder, .bounded = true, .solid = true, .extents = true},
    {.kind = ShapeKind::Rect, .bounded = true, .oneSided = true, .extents = true, .joins = true},
};
static_assert(inOrder(kShapeTraits, &ShapeTraits::kind), "a row for every kind, in the enum's order");

// Whether a kind is convex: a line meets it in one interval. All kinds must be. Where a shape's side faces a
// light, its shadow rays ignore the shape itself (shade/light.cpp). Between corners that show one shape, only
// nearer shapes are expected (picture/hidden.h). In-betweens reuse the colour of any part of the same shape
// (picture/between.cpp). So a torus would not shade itself, and its hole would be partly filled.
constexpr bool isConvex(ShapeKind k) {
    using enum ShapeKind;
    return k == Sphere || k == Plane || k == Box || k == Cylinder || k == Rect;
}
constexpr bool allConvex(int first = 0) {
    return first == (int)ShapeKind::Count || (isConvex((ShapeKind)first) && allConvex(first + 1));
}
static_assert(allConvex(), "a kind that is not convex, or that isConvex() does not list");

struct Shape {
    ShapeKind kind = ShapeKind::Sphere;
    uint8_t material = 0; // index into Scene::materials
    Vec3 centre = {};     // world
    Vec3 half = {};       // see above; positive
    Mat3 frame = kIdentity;
    bool aligned = true;    // the frame is the world's; set by Scene::finish()
    Vec3 textureShift = {}; // added to texture coordinates, so that no two balls look alike
    int chart = -1;         // index into the lightmap's charts, -1: lit by ambient light

    const ShapeTraits &traits() const { return kShapeTraits[(int)kind]; }
    // Most shapes are balls: the tracer has closed forms for them
    bool isBall() const { return kind == ShapeKind::Sphere; }
    bool isRectangle() const { return kind == ShapeKind::Rect; }
};

// These functions are never inlined, because their code is large.
[[gnu::noinline]] constexpr Shape sphere(const Vec3 &centre, float radius, int material) {
    return {.kind = ShapeKind::Sphere,
            .material = (uint8_t)material,
            .centre = centre,
            .half = {radius, radius, radius}};
}
// A plane through `point`, facing up.
[[gnu::noinline]] constexpr Shape plane(const Vec3 &point, int material) {
    return {.kind = ShapeKind::Plane, .material = (uint8_t)material, .centre = point};
}
[[gnu::noinline]] constexpr Shape box(const Vec3 &centre, const Vec3 &half, int material) {
    return {.kind = ShapeKind::Box, .material = (uint8_t)material, .centre = centre, .half = half};
}
// An upright cylinder.
[[gnu::noinline]] constexpr Shape cylinder(const Vec3 &middle, float radius, float halfHeight, int material) {
    return {.kind = ShapeKind::Cylinder,
            .material = (uint8_t)material,
            .centre = middle,
            .half = {radius, halfHeight, radius}};
}

} // namespace odraz
