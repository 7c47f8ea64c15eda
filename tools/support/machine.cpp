#include "tools/support/machine.h"

#include "host/headless.h"
#include "host/process.h"
#include "host/threads.h"

#include <stdexcept>
#include <unistd.h>

namespace odraz {

Workers allProcessors() {
    // A process can start only one set of threads
    static const Workers kAll = [] {
        Workers workers = serialWorkers();
        if (const char *missing = startWorkers(workers, (int)sysconf(_SC_NPROCESSORS_ONLN), &kNever))
            throw std::runtime_error(missing);
        return workers;
    }();
    return kAll;
}

Gl openGl() {
    Gl gl;
    Quiet libraries;
    if (const char *missing = openHeadlessGl(gl)) throw std::runtime_error(missing);
    return gl;
}

} // namespace odraz
