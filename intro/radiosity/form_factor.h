// Form factors from hemicubes: the share of a patch's view that every other patch fills.
//
// Each pixel of a hemicube has the form factor of its solid angle, integrated so finely that all pixels sum
// to 1 within 1e-6. Rows are sparse and stored one after the other.
#pragma once

#include "base/parallel.h"
#include "base/progress.h"
#include "radiosity/hemicube.h"

namespace odraz {

struct Link {
    uint32_t patch;
    float share;
};

struct FormFactorRow {
    const Link *links;
    int count;
    bool known; // false if no hemicube was filled
};

struct FormFactors {
    Link *links;
    FormFactorRow *rows; // one row for every patch
    size_t capacity, used;
};

// Computes the form factors of a hemicube's pixels: 3 px rows of px values, in the layout of hemicube.h.
void deltaFormFactors(int px, float *delta);

// Computes the running sums of `delta` along every row, starting at 0: px + 1 values a row.
void accumulateFormFactors(int px, const float *delta, float *sums);

// Adds the form factors of one hemicube's pixels to row[patch], by means of `sums`. Returns the form
// factor of the pixels that show nothing or a back. An empty pixel between two others in its row or column
// is a crack: it counts as one of them.
float sumHemicube(const Hemicubes &h, int index, const float *sums, float *row);

// Fills the hemicubes of all visible patches that reflect, and stores their rows. Returns false if the viewer
// left, hemicubes cannot be filled, or the capacity for links is too small; then `arena` is marked as full.
bool findFormFactors(const HemicubeMethod &method, Hemicubes &h, const Model &model, Workers &workers,
                     Arena &arena, FormFactors &factors, const Progress &progress);

} // namespace odraz
