// Errors for a solution that does not fit into --memory; they have the number of megabytes.
#pragma once

#include "base/arena.h"

namespace odraz::radiosity {

// Throws std::runtime_error: `bytes` are needed, `most` are allowed; `remedy` names the option to change.
[[noreturn]] void refuseMemory(size_t bytes, size_t most, const char *remedy);
// The same for an arena that cannot hold `more` bytes.
[[noreturn]] void refuseMemory(const Arena &arena, size_t more);

template <class T> T *takeOrRefuse(Arena &arena, size_t count) {
    if (T *p = arena.take<T>(count)) return p;
    refuseMemory(arena, count * sizeof(T));
}

} // namespace odraz::radiosity
