// The process itself: memory, standard descriptors, error messages, and its end.
#pragma once

#include <stddef.h>

namespace odraz {

void *takeMemory(size_t bytes);  // zeroed; null if there is not enough
extern const char kMoreMemory[]; // what to do in that case

// Null, or a line for the viewer if the system lets no process run code that it wrote itself
// (MemoryDenyWriteExecute, SELinux), as software OpenGL does.
const char *jitForbidden();

// Whether the process could address that many bytes more (ulimit -v).
bool couldAddress(size_t bytes);

// Writes "NAME: LINE", with the film's name, to standard error. Returns 1, the exit status of a failure. On
// Windows, a program with windows often has no standard descriptors: the line then appears in a message box.
int printError(const char *line);

// While a Quiet exists, what libraries write to standard error is discarded; printError() still prints.
struct Quiet {
    Quiet();
    ~Quiet();
};

// Calls printError(), and also shows the line in a small window, for viewers who double-clicked and see no
// standard error. The window closes at a key, at its button, or after half a minute. On Linux it opens if
// there is a display, on Windows if there is no standard error. Runs on any processor.
int showError(const char *line);

// Prepares the standard descriptors, and returns a bit for each one that is closed. On Linux a closed one is
// opened to /dev/null, so that no file of ours becomes standard error. Writing to a closed pipe, or beyond
// the limit of a file's size (ulimit -f), becomes an ordinary error. On Windows the console of the process
// that started us takes the place of closed ones, if it has a console.
int prepareDescriptors();

// Ends all threads at once.
[[noreturn]] void endProcess(int status);

} // namespace odraz
