// OpenGL for tests, without a display, even where there is one: one context for the whole program.
#pragma once

#include "host/headless.h"
#include "tools/engine/heap_arena.h"

#include <cstdlib>
#include <gtest/gtest.h>

inline const odraz::Gl &headlessGl() {
    static odraz::Gl gl;
    static const char *missing = [] {
        unsetenv("DISPLAY");
        return odraz::openHeadlessGl(gl);
    }();
    EXPECT_STREQ(missing, nullptr);
    return gl;
}
