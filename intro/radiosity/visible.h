// Finds which parts of a model are visible: it looks at the places around texels, eight texels at a time.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Eight texels, side by side.
struct Texels8 {
    Vec3x8 p, u, v, n; // the texel itself; its chart's axes and normal
    Float8 du, dv;     // a quarter of a cell's sides
    Float8 off;        // distance from the plane at which a point is on its side despite rounding
    Int8 active;

    // A place just off the plane, moved aside by x and y quarters of a cell's sides.
    Vec3x8 at(Float8 x, Float8 y) const { return p + u * (du * x) + v * (dv * y) + n * off; }
};
// The `count` texels from `first` on.
Texels8 loadTexels(const Model &model, int first, int count);

// One place of each of eight texels: number `round` (from 0) of those in its mask.
struct Places8 {
    Float8 x, y; // -1 or 1: on which side of the texel
    Int8 number; // 0 .. 3
    Int8 active;
};
Places8 placesOf(const int *masks, int round);

// Finds which places of all texels are visible: those on a facet and in no solid. `scene` must hold the
// posed, finished model; solids are closed, so that none of their backs is seen.
void findVisible(Model &model, const Scene &scene, Workers &workers);

} // namespace odraz
