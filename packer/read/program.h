// A program as it lies in memory, and what makes a file unsuitable.
#pragma once

#include "packer/stub/format.h"

#include <stdexcept>
#include <string>

namespace pack {

inline constexpr uint64_t kMostMemory = 64 << 20; // no program of ours is larger

// What makes a file unsuitable, as one line for the user.
struct Unsuitable : std::runtime_error {
    using std::runtime_error::runtime_error;
};
inline void need(bool condition, const std::string &otherwise) {
    if (!condition) throw Unsuitable(otherwise);
}

// What a program may take for granted where it runs: one library, and its two functions that find all others.
struct System {
    const char *library, *functions[2]; // open a library, and find a function in it
    const char *interpreter;            // null where there is none
};
inline constexpr System kLinux = {"libdl.so.2", {"dlopen", "dlsym"}, kInterpreter};
inline constexpr System kWindows = {"kernel32.dll", {"LoadLibraryA", "GetProcAddress"}, nullptr};

// As it lies in memory when it starts.
struct Program {
    uint32_t base; // address of the first byte; page-aligned
    std::vector<uint8_t>
        bytes;         // up to the last one that is not 0, at least one; the loader's tables are zeroed
    uint32_t readOnly; // bytes from base that are never written: code and constants; whole pages
    uint32_t span;     // bytes of memory, with the zeros behind the bytes
    uint32_t slots[2]; // addresses where it expects System::functions
    uint32_t entry;
    uint32_t early, earlyEntry;   // as in PayloadHeader
    uint32_t codeBegin, codeSize; // the stretch of `bytes` that is instructions

    Layout layout() const { return {(uint32_t)bytes.size(), codeBegin, codeSize}; }
};

} // namespace pack
