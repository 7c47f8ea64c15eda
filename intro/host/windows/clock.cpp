#include "host/clock.h"

#include "host/windows/windows.h"

namespace odraz {

int64_t nanoseconds() {
    int64_t now, second;
    QueryPerformanceCounter(&now);
    QueryPerformanceFrequency(&second);
    // Convert whole seconds separately: a single product would overflow
    return now / second * 1000000000 + now % second * 1000000000 / second;
}

int64_t processorNanoseconds() {
    uint64_t begun, ended, kernel, user; // in units of 100 nanoseconds
    GetProcessTimes(windows::kInvalid, &begun, &ended, &kernel, &user);
    return (int64_t)(kernel + user) * 100;
}

void sleepFor(int64_t nanoseconds) { Sleep((uint32_t)((nanoseconds + 999999) / 1000000)); }

} // namespace odraz
