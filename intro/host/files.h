// Files that are whole or absent.
#pragma once

#include <stddef.h>

namespace odraz {

// Each returns null, or what went wrong in a few words ("no space left on the device").
const char *writeAll(int descriptor, const void *data, size_t size);

// Writes `path` beside itself, under a name that nobody else uses (path + ".NUMBER.part"), and then renames
// it. What cannot be finished is removed. A pipe or a device is written to as it is.
const char *writeFile(const char *path, const void *data, size_t size);

const char *makeDirectory(const char *path); // fine when it is there already

bool isTerminal(int descriptor);

// Size of the running program's file, 0 if unknown.
long ownSize();

} // namespace odraz
