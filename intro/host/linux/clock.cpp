#include "host/clock.h"

#include "host/linux/sys.h"

namespace odraz {

int64_t nanoseconds() {
    int64_t now[2];
    sys::call(sys::kClockGettime, 1 /* CLOCK_MONOTONIC */, (long)now);
    return now[0] * 1000000000 + now[1];
}

} // namespace odraz
