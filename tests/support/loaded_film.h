// The film, loaded for pictures of one size.
#pragma once

#include "intro.h"
#include "tests/support/headless_gl.h"
#include "tests/support/threads.h"
#include "tools/support/heap_arena.h"

namespace odraz {

struct LoadedFilm {
    Threads threads;
    IntroSettings settings;
    HeapArena memory;
    Intro *intro = nullptr;

    // `pairs`: loads two slots, for in-betweens. With `gl`, solves the hall.
    LoadedFilm(int threadCount, int width, int height, bool pairs, const Gl *gl = nullptr)
        : threads(threadCount), settings{.width = width,
                                         .height = height,
                                         .pairs = pairs,
                                         .hall = gl != nullptr},
          memory(memoryNeeded(settings, threadCount)) {
        EXPECT_STREQ(load(intro, settings, memory.arena, threads.workers, kDrawnHemicubes, gl), nullptr);
    }
};

// The film at 160x90, with its hall if it has one. All tests of a program share it.
inline Intro &smallFilm() {
    static LoadedFilm loaded(1, 160, 90, false, needsHall(0, duration()) ? &headlessGl() : nullptr);
    return *loaded.intro;
}

} // namespace odraz
