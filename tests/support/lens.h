// Looking through one hemicube at a time: what tests of form factors need.
#pragma once

#include "radiosity/form_factor.h"
#include "tests/support/headless_gl.h"

#include <vector>

struct Lens {
    odraz::HeapArena memory;
    odraz::Hemicubes h = {};
    std::vector<float> sums;

    explicit Lens(int px) : memory(odraz::hemicubeBytes(px)), sums((size_t)(3 * px * (px + 1))) {
        EXPECT_TRUE(odraz::openHemicubes(h, headlessGl(), memory.arena, px));
        std::vector<float> delta((size_t)(3 * px * px));
        odraz::deltaFormFactors(px, delta.data());
        odraz::accumulateFormFactors(px, delta.data(), sums.data());
    }
    Lens(const Lens &) = delete;
    ~Lens() { odraz::closeHemicubes(h); }

    // The form factors of the hemicube drawn as number `index`, by patch; `dark` gets what saw nothing.
    std::vector<float> row(const odraz::Model &model, int index = 0, double *dark = nullptr) const {
        std::vector<float> row((size_t)model.patchCount);
        float left = odraz::sumHemicube(h, index, sums.data(), row.data());
        if (dark) *dark = (double)left;
        return row;
    }
    // ... of one place.
    std::vector<float> row(const odraz::Model &model, const odraz::Eye &eye, double *dark = nullptr) {
        odraz::drawHemicubes(h, model, &eye, 1);
        return row(model, 0, dark);
    }
};
