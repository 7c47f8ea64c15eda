// The process itself: memory, standard descriptors, saying no in one readable line, and its end.
#pragma once

#include <stddef.h>

namespace odraz {

void *takeMemory(size_t bytes);  // zeroed; null when there is none
extern const char kMoreMemory[]; // what to do then

// Null, or a line where the system lets nothing run that was written (MemoryDenyWriteExecute, SELinux).
const char *mayNotRunWritten();

// Whether so many bytes more could be had of what a process may address (ulimit -v).
bool couldAddress(size_t bytes);

// Writes "odraz: LINE" to standard error. Returns 1, the exit status of a failure. On Windows, where a
// program with windows mostly has no standard descriptors, in a box where there is no standard output either.
int complain(const char *line);

// While one lives, what libraries write to standard error is swallowed; complain() is heard.
struct Quiet {
    Quiet();
    ~Quiet();
};

// complain(), and for viewers who double-clicked and see no standard error, the line in a small window until
// a key, the close button, or for half a minute: on Linux where there is a display, on Windows where there is
// no standard error. Any processor.
int refuse(const char *line);

// Prepares what the shell left us, and returns a bit for every standard descriptor that is closed. On Linux
// these get a file that swallows all, so that no file of ours ends up as standard error, and a closed pipe or
// a file beyond the limit (ulimit -f) becomes an error of writing; on Windows the console of who started us
// takes their place, if there is one.
int prepareDescriptors();

// Ends all threads at once.
[[noreturn]] void endProcess(int status);

} // namespace odraz
