// A model and a hemicube that draws it, for tests of hemicubes.
#pragma once

#include "radiosity/solve.h"
#include "tests/support/model_bench.h"
#include "tests/support/single_hemicube.h"

namespace odraz {

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
