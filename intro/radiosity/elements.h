// Elements: the cells at the bottom of a divided model's quadtrees, divided on where light asks for it.
//
// The light of an element is that of the texels at its corners. Texels are looked at while they are fresh
// (visible.h, direct.h), cells are divided until they are fine enough, then frozen and tied (ties.h). Planes
// are arrays of one float a texel, texelCount + 8 of them.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// The texel at a place of a chart, in kSteps of an undivided cell; -1 where there is none.
int findTexel(const Model &model, int chart, int x, int y);

// They have been looked at.
void settleFresh(Model &model);

// Divides a cell into four; its level must be below the levels that divide() made room for. Texels that are
// new, or stand closer now, are fresh.
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

} // namespace odraz
