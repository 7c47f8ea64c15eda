// The film, loaded for pictures of one size.
#pragma once

#include "intro.h"
#include "tests/support/threads.h"
#include "tools/engine/heap_arena.h"

#include <gtest/gtest.h>

namespace odraz {

struct LoadedFilm {
    Threads threads;
    IntroSettings settings;
    HeapArena memory;
    Intro *intro = nullptr;

    // `pairs`: loads two slots, for in-betweens. With `gl`, solves the hall.
    LoadedFilm(int threadCount, int width, int height, bool pairs, const Gl *gl = nullptr)
        : threads(threadCount), settings{.width = width, .height = height, .pairs = pairs},
          memory(memoryNeeded(settings, threadCount, gl != nullptr)) {
        EXPECT_STREQ(load(intro, settings, memory.arena, threads.workers, gl), nullptr);
    }
};

} // namespace odraz
