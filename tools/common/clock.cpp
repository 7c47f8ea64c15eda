#include "tools/common/clock.h"

#include "tools/common/statistics.h"

#include <ctime>

namespace common {

static double secondsOf(clockid_t clock) {
    timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

double processorSeconds() { return secondsOf(CLOCK_PROCESS_CPUTIME_ID); }
double wallSeconds() { return secondsOf(CLOCK_MONOTONIC); }

double medianMs(const std::function<void()> &call, int rounds) {
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        int calls = 0;
        double began = processorSeconds(), now;
        do {
            call();
            ++calls;
            now = processorSeconds();
        } while (now - began < 0.01);
        times.push_back((now - began) * 1e3 / calls);
    }
    return median(times);
}

} // namespace common
