// The process itself: memory, standard descriptors, error messages, and its end.
#pragma once

#include <stddef.h>

namespace odraz {

void *takeMemory(size_t bytes);  // zeroed; null if there is not enough
extern const char kMoreMemory[]; // what the viewer can do in that case
// Gives whole pages of this memory back to the system. It must not be used again.
void giveBack(void *memory, size_t bytes);

// Returns null, or a line for the viewer if the system forbids generated code (MemoryDenyWriteExecute,
// SELinux), which software OpenGL needs.
const char *jitForbidden();

// Returns whether the process could map this many more bytes (ulimit -v).
bool couldAddress(size_t bytes);

// Writes "NAME: LINE", with the film's name, to standard error. Returns 1, the exit status of a failure. A
// program with windows often has no standard descriptors on Windows: the line then appears in a message box.
int printError(const char *line);

// While a Quiet exists, the output of libraries to standard error is discarded; printError() still prints.
struct Quiet {
    Quiet();
    ~Quiet();
};

// Calls printError(), and also shows the line in a small window, for viewers who double-clicked and see no
// standard error. A key, the close button or half a minute closes it. On Linux it opens if there is a
// display, on Windows if there is no standard error. Runs on any processor.
int showError(const char *line);

// Prepares the standard descriptors. Returns the closed ones: bit N is set if descriptor N is closed. On
// Linux a closed one is opened to /dev/null, so that no file of ours becomes standard error. Writing to a
// closed pipe, or beyond the limit of a file's size (ulimit -f), becomes an ordinary error. On Windows the
// console of the parent process, if it has one, replaces closed ones.
int prepareDescriptors();

// Ends the process and all its threads at once.
[[noreturn]] void endProcess(int status);

} // namespace odraz
