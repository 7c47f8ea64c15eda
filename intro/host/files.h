// Writes files so that they are either complete or absent.
#pragma once

#include <stddef.h>

namespace odraz {

// Each returns null, or what went wrong in a few words ("no space left on the device").
const char *writeAll(int descriptor, const void *data, size_t size);

// Writes a file beside `path`, under a name that is not in use (path + ".NUMBER.part"), and then renames it
// to `path`. If that fails, the file is removed. A pipe or a device is written to directly.
const char *writeFile(const char *path, const void *data, size_t size);

const char *makeDirectory(const char *path); // no error if it exists already

bool isTerminal(int descriptor);

// Size of the running program's file, 0 if unknown.
long ownSize();

} // namespace odraz
