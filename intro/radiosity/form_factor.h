// Form factors from hemicubes: what share of its light a patch gets from every other patch.
//
// Each pixel of a hemicube has the form factor of the solid angle that it covers, integrated so finely that
// those of a hemicube sum to 1 within 1e-6. Rows are sparse and stored one after the other.
#pragma once

#include "base/parallel.h"
#include "base/progress.h"
#include "radiosity/hemicube.h"

namespace odraz {

struct Link {
    uint32_t patch;
    float share;
};

struct Row {
    const Link *links;
    int count;
    bool known; // false if no hemicube was drawn
};

struct FormFactors {
    Link *links;
    Row *rows; // one row for every patch
    size_t capacity, used;
};

// The form factors of a hemicube's pixels, 3 px rows of px values in the layout of hemicube.h.
void deltaFormFactors(int px, float *delta);

// Their running sums along every row, starting at 0: px + 1 of each row.
void accumulateFormFactors(int px, const float *delta, float *sums);

// Adds the pixels of one hemicube to row[patch] for all patches of the model, using those sums. Returns the
// share of pixels that show nothing, or backs. An empty pixel between two that are not, in its line or
// column, is a crack of rasterisation; it counts as its neighbour.
float sumHemicube(const Hemicubes &h, int index, const float *sums, float *row);

// Draws the hemicubes of all visible patches that reflect, and keeps their rows. False when the viewer left
// or the capacity for links is too small.
bool findFormFactors(Hemicubes &h, const Model &model, Workers &workers, Arena &arena, FormFactors &factors,
                     const Progress &progress);

} // namespace odraz
