// A model with the memory, scene and workers that are needed to divide and solve it.
#pragma once

#include "radiosity/visible.h"
#include "tools/support/heap_arena.h"

namespace odraz {

struct ModelBench {
    HeapArena memory{(size_t)200 << 20};
    Workers workers = serialWorkers();
    std::unique_ptr<Model> model = std::make_unique<Model>();
    std::unique_ptr<Scene> scene = std::make_unique<Scene>();

    // Fills the scene with the model, so that rays can be traced.
    void pose() {
        model->pose(*scene);
        scene->finish();
    }
    // Divides the model into patches of `block` by `block` cells.
    void divide(int block) {
        EXPECT_TRUE(model->divide(memory.arena, block));
        findVisible(*model, *scene, workers);
        model->placePatches();
    }
};

} // namespace odraz
