// Clocks, and waiting.
#pragma once

#include <stdint.h>

namespace odraz {

int64_t nanoseconds();          // a monotonic clock with an arbitrary start
int64_t processorNanoseconds(); // processor time that all threads of this process have used
void sleepFor(int64_t nanoseconds);

} // namespace odraz
