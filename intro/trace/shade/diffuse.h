// The diffuse colour of places: texture and checker, and the lines between patches over them.
#pragma once

#include "trace/rays/view.h"
#include "trace/scene/scene.h"

namespace odraz {

// Whether all of a material's places have the first colour of its palette times its weight.
ODRAZ_INLINE bool onePlainColour(const Scene &scene, const Material &m) {
    return m.diffuse == 0 || (m.plain() && scene.lines == 0);
}

// Of eight places of a shape, seen along d by samples `width` wide (world units, across d). `cell` tells
// cells of a checker apart, or, in a scene that shows its patches, these.
Rgb8 diffuseColour(const Scene &scene, const Shape &shape, const Vec3x8 &p, const Vec3x8 &d, Float8 cosine,
                   Float8 width, Int8 &cell);

// What eight picture points show of one shape's surface, to samples `size` pixels wide.
Rgb8 albedoSeen(const Scene &scene, const View &view, const Shape &shape, Float8 x, Float8 y, float size);

} // namespace odraz
