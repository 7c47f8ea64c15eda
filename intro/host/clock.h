// Time as it passes.
#pragma once

#include <stdint.h>

namespace odraz {

int64_t nanoseconds();          // monotonic, from any moment
int64_t processorNanoseconds(); // that all threads of this process have worked
void sleepFor(int64_t nanoseconds);

} // namespace odraz
