// OpenGL for tests. It uses no display, even if there is one. The whole program shares one context.
#pragma once

#include "host/headless.h"
#include "tools/support/heap_arena.h"

#include <cstdlib>

inline const odraz::Gl &headlessGl() {
    static odraz::Gl gl;
    static const char *missing = [] {
        unsetenv("DISPLAY");
        return odraz::openHeadlessGl(gl);
    }();
    EXPECT_STREQ(missing, nullptr);
    return gl;
}
