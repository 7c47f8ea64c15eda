// Reads whole files, and writes them whole or not at all.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace odraz {

// Throws Refused (arguments.h) with a line that names the file and the reason.
std::string readWhole(const std::string &path);

// The same where a copy would take too long. Aligned as memory from new is.
struct WholeFile {
    std::unique_ptr<char[]> bytes;
    size_t size = 0;
    std::string_view view() const { return {bytes.get(), size}; }
};
WholeFile readWholeFile(const std::string &path);

// Its first `size` bytes, or all if it has fewer.
std::string readStart(const std::string &path, size_t size);

// Throws Refused if a file surely cannot be written: better to say so before minutes of work than after them.
void checkWritable(const std::string &path);

// Writes a file beside `path` and renames it. Throws std::runtime_error with a line that names the file and
// the reason.
void writeWhole(const std::string &path, const std::string &text);

} // namespace odraz
