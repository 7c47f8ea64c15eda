// OpenGL for tests, without a display: one context for the whole program. And an arena on the heap.
#pragma once

#include "base/arena.h"
#include "host/headless.h"

#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>

inline const odraz::Gl &headlessGl() {
    static odraz::Gl gl;
    static const char *missing = odraz::openHeadlessGl(gl);
    EXPECT_STREQ(missing, nullptr);
    return gl;
}

struct HeapArena {
    std::unique_ptr<unsigned char[], decltype(&free)> memory{nullptr, free};
    odraz::Arena arena;
    explicit HeapArena(size_t bytes) {
        bytes = (bytes + 63) & ~(size_t)63;
        memory.reset((unsigned char *)aligned_alloc(64, bytes));
        memset(memory.get(), 0, bytes);
        arena = {memory.get(), bytes, 0};
    }
};
