// A model with what dividing and solving it need.
#pragma once

#include "radiosity/model.h"
#include "tools/engine/heap_arena.h"

#include <memory>

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
};

} // namespace odraz
