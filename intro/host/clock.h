// Time as it passes.
#pragma once

#include <stdint.h>

namespace odraz {

int64_t nanoseconds(); // monotonic, from any moment

} // namespace odraz
