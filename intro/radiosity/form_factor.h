// Form factors from hemicubes: what share of its light a patch gets from every other one.
//
// Each pixel of a hemicube has the exact form factor of the solid angle it covers, the corner differences of
// an integral (see form_factor.cpp), so that a hemicube's pixels sum to 1 within 1e-6. Rows are sparse and
// stored one after the other.
#pragma once

#include "base/parallel.h"
#include "base/progress.h"
#include "radiosity/hemicube.h"

namespace odraz {

struct Link {
    uint32_t patch;
    float share;
};

// Row i is links[start[i]] .. links[start[i + 1] - 1].
struct FormFactors {
    Link *links;
    size_t *start;
    size_t capacity;
};

// The form factors of a hemicube's pixels, 3 px rows of px as hemicube.h lays them out.
void deltaFormFactors(int px, float *delta);

// Adds the pixels of one hemicube to row[patch], for all patches of the model; returns what saw nothing or
// the backs of things. A pixel that saw nothing between two that did is a crack of rasterisation; it gets
// what its neighbour saw.
float sumHemicube(const Hemicubes &h, int index, const float *delta, float *row);

// Draws the hemicubes of all patches that have some share and keeps their rows; windows and patches without
// reflectance have no rows and are left out of those of others (`reflects`, by material). False when the
// viewer left or the links' capacity is too small.
bool findFormFactors(Hemicubes &h, const Model &model, const bool *reflects, Workers &workers, Arena &arena,
                     FormFactors &factors, const Progress &progress);

} // namespace odraz
