// OpenGL for tests, without a display: one context for the whole program.
#pragma once

#include "host/headless.h"
#include "tools/engine/heap_arena.h"

#include <gtest/gtest.h>

inline const odraz::Gl &headlessGl() {
    static odraz::Gl gl;
    static const char *missing = odraz::openHeadlessGl(gl);
    EXPECT_STREQ(missing, nullptr);
    return gl;
}
