// Reads whole files, and writes files whole or not at all. An output never overwrites an input or another
// output of the same run.
#pragma once

#include "tools/common/command_line.h"

#include <string>
#include <string_view>

namespace common {

// Reads a regular file of at most 4 GB. Throws Refused (command_line.h) with the file's name and the reason.
std::string readWhole(const std::string &path);

// Reads the first `size` bytes of a file, or all if it has fewer.
std::string readStart(const std::string &path, size_t size);

// Calls `body`. If it throws Refused, puts the file's name in front of the error, unless it is there already.
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

// Runs a shell's command. Returns what it prints; sets `status` to that of wait(2). Throws
// std::runtime_error.
std::string outputOf(const std::string &command, int *status = nullptr);

// Throws Refused if the file certainly cannot be written, so that minutes of work are not lost.
void checkWritable(const std::string &path);

// Notes an input of a run. readWhole() does so itself. Throws WouldReplace if the file,
// by whatever name, is an output.
void noteInput(const std::string &path);
// Claims an output that the user named, before work begins. Throws Refused if it cannot be written, or is an
// input or another output, by whatever name. The input `replaces` may be overwritten. Returns false for a
// pipe or a device. If the output is standard output, printed text goes to standard error instead.
bool claimOutput(const std::string &path, const std::string &replaces = "");
// Forgets all inputs and outputs. Each command line begins a new run.
void forgetFiles();
// Thrown by readers instead of Refused, since some callers go on without a file that cannot be read.
struct WouldReplace : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Writes a temporary file in the same folder and renames it to `path`, or to the target of a symbolic link. A
// pipe, a device or an open descriptor (/dev/stdout) is written to directly. `mode`: permissions as for
// chmod; 0: the default for new files. Throws std::runtime_error with the file's name and the reason.
void writeWhole(const std::string &path, std::string_view bytes, unsigned mode = 0);

// Removes the file that writeWhole() would replace. Returns false if there is no such file, or if
// writeWhole() would write to it directly.
bool removeWhole(const std::string &path);

} // namespace common
