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

struct Row {
    const Link *links;
    int count;
    bool known; // false where no hemicube was drawn: there is none, or it was not reached
};

struct FormFactors {
    Link *links;
    Row *rows; // of every patch
    size_t capacity, used;
};

// The form factors of a hemicube's pixels, 3 px rows of px as hemicube.h lays them out.
void deltaFormFactors(int px, float *delta);

// Their sums along every row, from 0 on: px + 1 of each.
void accumulateFormFactors(int px, const float *delta, float *sums);

// Adds the pixels of one hemicube to row[patch], for all patches of the model, by those sums; returns what
// saw nothing or the backs of things. A pixel that saw nothing between two that did, in its line or column,
// is a crack of rasterisation; it gets what its neighbour saw.
float sumHemicube(const Hemicubes &h, int index, const float *sums, float *row);

// What a patch is to form factors: nothing; it has a row, and is in those of others; or that alone.
enum : uint8_t { kUnlit, kReflects, kShines };

// Draws the hemicubes of all patches that have some share and keeps their rows, as `lit` tells of each.
// `step`, without a factor in common with the number of patches, is how many patches lie from one to the
// next, so that rows that are had when it is stopped are spread over the model. False when the viewer left or
// the links' capacity is too small; what there is then is whole.
bool findFormFactors(Hemicubes &h, const Model &model, const uint8_t *lit, Workers &workers, Arena &arena,
                     FormFactors &factors, const Progress &progress, int step = 1);

} // namespace odraz
