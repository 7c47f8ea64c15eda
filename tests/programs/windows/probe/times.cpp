// Clocks.
#include "probe.h"

#include "host/clock.h"

#include <initializer_list>

using namespace odraz;

namespace probe {

void times() {
    int64_t last = nanoseconds(), first = last;
    int back = 0;
    for (int i = 0; i < 100000; ++i) {
        int64_t now = nanoseconds();
        back += now < last;
        last = now;
    }
    check("the clock never goes back", !back, back);
    check("... and goes on", last > first, last - first);

    // Compare with another clock of Windows, in milliseconds, whose ticks may be 16 ms
    auto ticks = (PROBE_WINDOWS uint64_t(*)())function("kernel32.dll", "GetTickCount64");
    int64_t tick = (int64_t)ticks();
    first = nanoseconds();
    sleepFor(500000000);
    int64_t tickPassed = ((int64_t)ticks() - tick) * 1000000, outer = nanoseconds() - first;
    check("... as fast as another clock", outer + 40000000 > tickPassed && outer > 400000000,
          outer - tickPassed);
    // Repeat if the thread was interrupted between the readings
    for (int i = 0; i < 100; ++i) {
        tick = (int64_t)ticks();
        first = nanoseconds();
        sleepFor(100000000);
        outer = nanoseconds() - first;
        tickPassed = ((int64_t)ticks() - tick) * 1000000;
        if (outer < tickPassed + 40000000) break;
    }
    check("... and no faster", outer < tickPassed + 40000000, outer - tickPassed);

    for (int64_t least : {1, 1000000, 1000001, 5500000, 70000000}) {
        first = nanoseconds();
        sleepFor(least);
        check("sleep lasts long enough", nanoseconds() - first >= least, nanoseconds() - first);
    }

    int64_t worked = processorNanoseconds(), from = nanoseconds();
    sleepFor(1000000000);
    int64_t idle = processorNanoseconds() - worked;
    check("sleep takes no processor time", idle >= 0 && idle < 500000000, idle);
    worked = processorNanoseconds();
    from = nanoseconds();
    while (processorNanoseconds() - worked < 300000000 && nanoseconds() - from < 100000000000) {
    }
    worked = processorNanoseconds() - worked;
    check("work does", worked >= 300000000, worked);
    check("... not longer than time passes", worked < nanoseconds() - from + 40000000, worked);
}

} // namespace probe
