// Finds the visible parts of a model: tests the sample points of texels, eight texels at a time.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// Eight consecutive texels.
struct Texels8 {
    Vec3x8 p, u, v, n; // the texel; its chart's axes and normal
    Float8 du, dv;     // a quarter of a cell's sides
    Float8 off;        // offset from the plane, large enough to be in front of it despite rounding
    Int8 active;

    // A point just in front of the plane, moved by x and y quarters of a cell's sides.
    Vec3x8 at(Float8 x, Float8 y) const { return p + u * (du * x) + v * (dv * y) + n * off; }
};
// Loads the `count` texels from `first` on.
Texels8 loadTexels(const Model &model, int first, int count);

// One sample point of each of eight texels: number `round`, from 0, of the points in the texel's mask.
struct TexelPoints8 {
    Float8 x, y; // -1 or 1: left or right, lower or upper half of the texel
    Int8 index;  // 0 .. 3
    Int8 active;
};
TexelPoints8 pointsOf(const int *masks, int round);

// Finds the visible sample points of all texels: those on a facet and not inside a solid. `scene` must
// contain the posed, finished model. Solids must be closed, so that their backs are invisible from outside.
void findVisible(Model &model, const Scene &scene, Workers &workers);

} // namespace odraz
