// What of a model is to be seen: the places about its texels, looked at eight texels at a time.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Eight texels, side by side.
struct Texels8 {
    Vec3x8 p, u, v, n; // the texel itself; its chart's axes and normal
    Float8 du, dv;     // a quarter of a cell's sides
    Float8 off;        // how far off the plane points lie surely on its side
    Int8 active;

    // Just off the plane, so many quarters aside.
    Vec3x8 at(Float8 x, Float8 y) const { return p + u * (du * x) + v * (dv * y) + n * off; }
};
// Those of the given numbers, `count` of them.
Texels8 loadTexels(const Model &model, const int *numbers, int count);

// Eight texels' places of one round: of each the round-th that its mask has.
struct Places8 {
    Float8 x, y; // -1 or 1: on which side of the texel
    Int8 number; // 0 .. 3
    Int8 active;
};
Places8 placesOf(const int *masks, int round);

// Finds which places of the fresh texels are to be seen: those on a facet that lie in no solid.
void findVisible(Model &model, const Scene &scene, Workers &workers);

} // namespace odraz
