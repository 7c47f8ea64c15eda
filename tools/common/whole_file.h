// Reads whole files, and writes them whole or not at all. No output of a run replaces an input or another
// output.
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

// What a run reads and will write: a program claims the outputs that its user names, before it works, and
// notes the inputs that it does not read whole, which are noted by themselves. An output that is an input, by
// whatever name, is refused by the later of both calls; but `replaces` may be written over. So is one that
// cannot be written, or is another output. claimOutput() returns false for a pipe or a device; if that is
// standard output, what is printed goes to standard error. Each command line begins a run.
void noteInput(const std::string &path);
bool claimOutput(const std::string &path, const std::string &replaces = "");
void forgetFiles();
// Thrown instead of Refused by readers, some of which go on without a file that they cannot read.
struct WouldReplace : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Writes a file beside `path` and renames it; of a symbolic link the target is written. A pipe or a device is
// written to directly, as is an open descriptor (/dev/stdout). `mode`: the file's permissions, as chmod takes
// them; 0 for those of any new file. Throws std::runtime_error with a line that names the file and the
// reason.
void writeWhole(const std::string &path, std::string_view bytes, unsigned mode = 0);

// Removes the file that writeWhole() would replace; not what it would write to directly. False: there is
// none.
bool removeWhole(const std::string &path);

} // namespace common
