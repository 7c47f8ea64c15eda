// Elements: the cells at the bottom of a model's quadtrees. They are divided further where light varies.
//
// The light of an element is that of the texels at its corners. New texels are fresh until their visibility
// and direct light have been found (visible.h, direct.h). Cells are divided until they are fine enough, then
// frozen and tied (ties.h). Planes are arrays of one float a texel, texelCount + 8 of them.
#pragma once

#include "radiosity/model.h"

namespace odraz {

// The texel at a place of a chart, in kSteps of an undivided cell; -1 if there is none.
int findTexel(const Model &model, int chart, int x, int y);

// Marks all texels as no longer fresh: to be called when their visibility and direct light have been found.
void settleFresh(Model &model);

// Divides a cell into four; its level must be below the number of levels that divide() made room for. Texels
// become fresh if they are new, or if their cells are smaller now.
void split(Model &model, int cell);

// How much light may change over a cell: by `least` plus a share of the light there.
struct Measure {
    const float *plane;
    float least;
};
// Sets `least` to `contrast` times the root mean square of the plane; false if the plane is dark.
bool measure(const Model &model, const float *plane, float contrast, Measure &measure);
// Divides those cells of a level over which one of the measured planes changes by more than `least` plus
// `contrast` times its sum, and those that are partly hidden.
void refine(Model &model, int level, const Measure *measures, int count, float contrast);

} // namespace odraz
