// Workers on threads of the system.
#pragma once

#include "base/parallel.h"

namespace odraz {

// Processors that this process may run on; >= 1.
int cpuCount();

// Starts count - 1 threads, kMaxWorkers - 1 at most, which sleep until there is work; they live as long as
// the process. Returns null, or what is missing. `abort` is that of Workers.
const char *startWorkers(Workers &workers, int count, const int *abort);

// Runs body(context) on a thread of its own. Returns null, or what is missing. The system calls it with a
// stack aligned to 16 bytes and the engine needs 32, so a body must have the attribute
// force_align_arg_pointer.
const char *startThread(void *(*body)(void *), void *context);
extern const char kMoreThreads[]; // what to do if the system has no room for one

} // namespace odraz
