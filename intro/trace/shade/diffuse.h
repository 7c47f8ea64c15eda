// The diffuse colour of surfaces: textures, checkers, and the lines between patches.
#pragma once

#include "trace/rays/view.h"
#include "trace/scene/scene.h"

namespace odraz {

// Whether a material has one colour everywhere: the first colour of its palette times `diffuse`.
ODRAZ_INLINE bool onePlainColour(const Scene &scene, const Material &m) {
    return m.diffuse == 0 || (m.plain() && scene.lines == 0);
}

// The diffuse colour at eight points of a shape, seen along d by samples `width` wide (world units, across
// d). `cell` gets the number of the checker's cell or, in a scene that shows its patches, of the patch.
Rgb8 diffuseColour(const Scene &scene, const Shape &shape, const Vec3x8 &p, const Vec3x8 &d, Float8 cosine,
                   Float8 width, Int8 &cell);

// The diffuse colour of a shape as seen at eight points of the picture by samples of width `size`, in pixels.
Rgb8 albedoSeen(const Scene &scene, const View &view, const Shape &shape, Float8 x, Float8 y, float size);

} // namespace odraz
