// Files that tools read whole, and write whole or not at all.
#pragma once

#include <string>

namespace odraz {

// Throws Refused (arguments.h) with a line that names the file and tells why not.
std::string readWhole(const std::string &path);

// Throws Refused where a file surely cannot be written: better said before minutes of work than after.
void checkWritable(const std::string &path);

// Writes beside and renames. Throws std::runtime_error with such a line.
void writeWhole(const std::string &path, const std::string &text);

} // namespace odraz
