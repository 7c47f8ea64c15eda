// Draws one hemicube at a time, for tests of form factors.
#pragma once

#include "radiosity/form_factor.h"
#include "tests/support/headless_gl.h"

#include <vector>

namespace odraz {

struct Lens {
    HeapArena memory;
    Hemicubes h = {};
    std::vector<float> sums;

    explicit Lens(int px) : memory(hemicubeBytes(px)), sums((size_t)(3 * px * (px + 1))) {
        EXPECT_TRUE(openHemicubes(h, headlessGl(), memory.arena, px));
        std::vector<float> delta((size_t)(3 * px * px));
        deltaFormFactors(px, delta.data());
        accumulateFormFactors(px, delta.data(), sums.data());
    }
    Lens(const Lens &) = delete;
    ~Lens() { closeHemicubes(h); }

    // The form factors, by patch, of the hemicube drawn as number `index`; `dark` gets the share that saw
    // nothing.
    std::vector<float> row(const Model &model, int index = 0, double *dark = nullptr) const {
        std::vector<float> row((size_t)model.patchCount);
        float left = sumHemicube(h, index, sums.data(), row.data());
        if (dark) *dark = (double)left;
        return row;
    }
    // Draws a hemicube at a place and returns its form factors.
    std::vector<float> row(const Model &model, const Eye &eye, double *dark = nullptr) {
        drawHemicubes(h, model, &eye, 1);
        return row(model, 0, dark);
    }
};

} // namespace odraz
