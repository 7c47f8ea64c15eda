#include "host/clock.h"

#include "host/linux/sys.h"

namespace odraz {

static int64_t read(int clock) {
    int64_t now[2];
    sys::call(sys::kClockGettime, clock, (long)now);
    return now[0] * 1000000000 + now[1];
}

int64_t nanoseconds() { return read(1 /* CLOCK_MONOTONIC */); }
int64_t processorNanoseconds() { return read(2 /* CLOCK_PROCESS_CPUTIME_ID */); }

void sleepFor(int64_t nanoseconds) {
    int64_t time[2] = {nanoseconds / 1000000000, nanoseconds % 1000000000};
    sys::call(sys::kNanosleep, (long)time, 0);
}

} // namespace odraz
