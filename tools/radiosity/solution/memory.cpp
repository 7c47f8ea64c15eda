#include "tools/radiosity/solution/memory.h"

#include <stdexcept>
#include <string>

namespace odraz::radiosity {

void refuseMemory(size_t bytes, size_t most, const char *remedy) {
    throw std::runtime_error("needs about " + std::to_string(bytes >> 20) + " MB, more than the " +
                             std::to_string(most >> 20) + " of --memory: " + remedy);
}

} // namespace odraz::radiosity
