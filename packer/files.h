// Reads and writes whole files. On failure the functions return false, and errno says why.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pack {

bool readFile(const char *path, std::vector<uint8_t> &bytes);

// Writes a new file beside the target, then renames it, so that the target is never half-written. A pipe or a
// device is written to directly.
bool writeFile(const std::string &path, const void *bytes, size_t size, bool executable);

// Whether writeFile() can be expected to succeed: the folder is there and may be written.
bool canWrite(const std::string &path);

// In bytes; -1 if there is no such file.
long fileSize(const char *path);

} // namespace pack
