// Files: each one is written completely or not at all.
#pragma once

#include <stddef.h>

namespace odraz {

// Returned texts are null on success, else they say what went wrong ("no space left on the device").
const char *writeAll(int descriptor, const void *data, size_t size);

// Writes a file next to `path`, under an unused name (path + ".NUMBER.part"), and then renames it to `path`.
// If that fails, it removes the new file. A pipe or a device is written to directly.
const char *writeFile(const char *path, const void *data, size_t size);

const char *makeDirectory(const char *path); // no error if it exists already

bool isTerminal(int descriptor);

// Returns the size of the running program's file in bytes; 0 if unknown.
long ownSize();

} // namespace odraz
