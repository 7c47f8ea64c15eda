// Workers on threads of the system.
#pragma once

#include "base/parallel.h"

namespace odraz {

// Returns the number of processors that this process may use; >= 1.
int cpuCount();

// Starts count - 1 threads, at most kMaxWorkers - 1, which sleep until there is work. They live as long as
// the process. `abort` becomes workers.abort. Returns null, or what is missing.
const char *startWorkers(Workers &workers, int count, const int *abort);

// Runs body(context) on a new thread. Returns null, or what is missing. The system aligns the stack to 16
// bytes, but the engine needs 32, so a body must have the attribute force_align_arg_pointer.
const char *startThread(void *(*body)(void *), void *context);
extern const char kMoreThreads[]; // what the viewer can do if no thread can be started

} // namespace odraz
