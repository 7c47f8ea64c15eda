// Draws one hemicube at a time, for tests of form factors.
#pragma once

#include "radiosity/form_factor.h"
#include "tests/support/headless_gl.h"

namespace odraz {

struct SingleHemicube {
    HeapArena memory;
    Hemicubes h = {};
    std::vector<float> sums;

    explicit SingleHemicube(int px) : memory(hemicubeBytes(px)), sums((size_t)(3 * px * (px + 1))) {
        EXPECT_TRUE(openHemicubes(h, headlessGl(), memory.arena, px));
        std::vector<float> delta((size_t)(3 * px * px));
        deltaFormFactors(px, delta.data());
        accumulateFormFactors(px, delta.data(), sums.data());
    }
    SingleHemicube(const SingleHemicube &) = delete;
    ~SingleHemicube() { closeHemicubes(h); }

    // Returns the form factors, by patch, of hemicube `index` of the last drawing. `dark` gets the share of
    // the hemicube in which nothing is visible.
    std::vector<float> row(const Model &model, int index = 0, double *dark = nullptr) const {
        std::vector<float> row((size_t)model.patchCount);
        float left = sumHemicube(h, index, sums.data(), row.data());
        if (dark) *dark = (double)left;
        return row;
    }
    // Draws the hemicube of `eye` and returns its form factors.
    std::vector<float> row(const Model &model, const Eye &eye, double *dark = nullptr) {
        EXPECT_TRUE(drawHemicubes(h, model, &eye, 1));
        return row(model, 0, dark);
    }
};

} // namespace odraz
