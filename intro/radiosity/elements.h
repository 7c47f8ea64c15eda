// Elements: the cells of a divided model, and the texels at their corners.
//
// They are refined where light asks for it, then frozen: the texels that hang in the middle of a larger
// neighbour's side, and those that are hidden, are tied to others, so that light has neither cracks nor dark
// rims. Planes are arrays of one float a texel, texelCount + 8 of them.
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

// Eight texels' places of one round: of each the round-th that its mask has.
struct Places8 {
    Float8 x, y; // -1 or 1: on which side of the texel
    Int8 number; // 0 .. 3
    Int8 active;
};
Places8 placesOf(const int *masks, int round);

// Those of the given numbers, `count` of them.
Texels8 loadTexels(const Model &model, const int *numbers, int count);

// Finds which places of the fresh texels are to be seen.
void findVisible(Model &model, const Scene &scene, Workers &workers);

// They have been looked at.
void settleFresh(Model &model);

// Divides a cell into four, unless there is no room. Texels that are new, or stand closer now, are fresh.
void split(Model &model, int cell);

// What light may change by over a cell: `least` and a share of what is there.
struct Measure {
    const float *plane;
    float least;
};
// With `contrast` times the root mean square of a plane as the least; false where it is dark.
bool measure(const Model &model, const float *plane, float contrast, Measure &measure);
// Divides the cells of a level over which one of the measured planes changes by more than that and `contrast`
// of its sum, and those that are hidden in part.
void refine(Model &model, int level, const Measure *measures, int count, float contrast);

// Ties hanging and hidden texels, once the cells are final.
void tie(Model &model);
// Moves the values of a plane as the ties say.
void settle(const Model &model, float *plane);

// Adds up a plane over the places of every patch that can be seen: patches' means in mean[patch * stride].
void meansOfPatches(const Model &model, const float *plane, float *mean, int stride);

// Spreads values of patches ([patches][columns], `columns` a multiple of 8) over the texels: bilinear between
// the patches' middles, straight on outside of them, but not below half of the least. Column k is added to
// planes[k], for `count` of them. The first `tied` columns may be negative and must stay a linear system: all
// go as far outside as the first one may.
void addToTexels(const Model &model, const float *values, int columns, float *const *planes, int count,
                 Workers &workers, int tied = 0);

} // namespace odraz
