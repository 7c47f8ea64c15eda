// Hemicubes that are drawn one at a time, and a model that they draw.
#pragma once

#include "radiosity/form_factor.h"
#include "radiosity/solve.h"
#include "tests/support/headless_gl.h"
#include "tests/support/model_bench.h"

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

struct HemicubeBench : ModelBench {
    std::unique_ptr<SingleHemicube> hemicube;

    void open(int px, int block) {
        pose();
        divide(block);
        hemicube = std::make_unique<SingleHemicube>(px);
    }
    Hemicubes &hemicubes() { return hemicube->h; }
    std::vector<float> row(const Eye &eye, double *dark = nullptr) {
        return hemicube->row(*model, eye, dark);
    }
    std::set<uint32_t> visibleIds(const Eye &eye) {
        Hemicubes &h = hemicubes();
        EXPECT_TRUE(drawHemicubes(h, *model, &eye, 1));
        std::set<uint32_t> ids;
        for (int y = 0; y < 3 * h.px; ++y)
            for (int x = 0; x < h.px; ++x) ids.insert(hemicubeIds(h, 0)[y * hemicubeStride(h) + x]);
        return ids;
    }
};

} // namespace odraz
