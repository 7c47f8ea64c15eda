// Reads whole files, and writes them whole or not at all.
#pragma once

#include "tools/common/command_line.h"

#include <memory>
#include <string>
#include <string_view>

namespace common {

// Reads a regular file of at most 4 GB. Throws Refused (command_line.h) with a line that names the file and
// the reason.
std::string readWhole(const std::string &path);

// The same without a copy. The bytes are aligned as memory from new is.
struct WholeFile {
    std::unique_ptr<char[]> bytes;
    size_t size = 0;
    std::string_view view() const { return {bytes.get(), size}; }
};
WholeFile readWholeFile(const std::string &path);

// Its first `size` bytes, or all if it has fewer.
std::string readStart(const std::string &path, size_t size);

// Calls `body`, and puts the file's name in front of the errors that it throws, if it is not there yet.
template <class Body> auto inFile(const std::string &path, Body body) {
    try {
        return body();
    } catch (const Refused &e) {
        const std::string why = e.what(), start = path + ": ";
        throw Refused(why.starts_with(start) ? why : start + why);
    }
}

// Reads and parses a file. Errors of `parse` begin with the file's name.
template <class Parse> auto parseFile(const std::string &path, Parse parse) {
    std::string text = readWhole(path);
    return inFile(path, [&] { return parse(text); });
}

// Throws Refused if a file certainly cannot be written, so that minutes of work are not lost.
void checkWritable(const std::string &path);

// Writes a file beside `path` and renames it; a pipe or a device is written to directly, and of a symbolic
// link the target is written. `mode`: the file's permissions, as chmod takes them; 0 for those of any new
// file. Throws std::runtime_error with a line that names the file and the reason.
void writeWhole(const std::string &path, std::string_view bytes, unsigned mode = 0);

} // namespace common
