// An error for a solution that does not fit into --memory.
#pragma once

#include <cstddef>

namespace odraz::radiosity {

// Throws std::runtime_error: `bytes` are needed, `most` are allowed; `remedy` names the option to change.
[[noreturn]] void refuseMemory(size_t bytes, size_t most, const char *remedy);

} // namespace odraz::radiosity
