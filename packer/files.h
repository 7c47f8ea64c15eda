// Files, read and written whole. On failure: false, and errno says why.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pack {

bool readFile(const char *path, std::vector<uint8_t> &bytes);

// Beside the target first, under a name of its own, so that it is never half-written. A pipe or a device is
// written to as it is.
bool writeFile(const std::string &path, const void *bytes, size_t size, bool executable);

// -1 if there is no such file.
long fileSize(const char *path);

} // namespace pack
