// Reads whole files, and writes them whole or not at all.
#pragma once

#include <string>

namespace odraz {

// Throws Refused (arguments.h) with a line that names the file and the reason.
std::string readWhole(const std::string &path);

// Throws Refused if a file surely cannot be written: better to say so before minutes of work than after them.
void checkWritable(const std::string &path);

// Writes a file beside `path` and renames it. Throws std::runtime_error with a line that names the file and
// the reason.
void writeWhole(const std::string &path, const std::string &text);

} // namespace odraz
