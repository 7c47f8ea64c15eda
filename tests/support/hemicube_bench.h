// A model with its own hemicube, for tests of what hemicubes see.
#pragma once

#include "radiosity/solve.h"
#include "tests/support/lens.h"
#include "tests/support/model_bench.h"

#include <set>
#include <vector>

namespace odraz {

struct HemicubeBench : ModelBench {
    std::unique_ptr<Lens> lens;

    void open(int px, int block) {
        pose();
        divide(block);
        lens = std::make_unique<Lens>(px);
    }
    Hemicubes &hemicubes() { return lens->h; }
    std::vector<float> row(const Eye &eye, double *dark = nullptr) { return lens->row(*model, eye, dark); }
    std::set<uint32_t> seen(const Eye &eye) {
        Hemicubes &h = hemicubes();
        drawHemicubes(h, *model, &eye, 1);
        std::set<uint32_t> ids;
        for (int y = 0; y < 3 * h.px; ++y)
            for (int x = 0; x < h.px; ++x) ids.insert(hemicubeIds(h, 0)[y * hemicubeStride(h) + x]);
        return ids;
    }
};

} // namespace odraz
