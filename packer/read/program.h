// A program as it lies in memory, its file, and what makes a file unsuitable.
#pragma once

#include "packer/stub/format.h"
#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pack {

// Whole files. Errors are those of tools/common/whole_file.h
using Bytes = std::vector<uint8_t>;

inline Bytes readBytes(const std::string &path) {
    common::WholeFile file = common::readWholeFile(path);
    return {file.view().begin(), file.view().end()};
}

// The permissions of a file, as chmod takes them.
inline unsigned modeOf(const std::string &path) {
    return (unsigned)std::filesystem::status(path).permissions() & 0777;
}

inline void writeBytes(const std::string &path, const Bytes &bytes, unsigned mode = 0) {
    common::writeWhole(path, {(const char *)bytes.data(), bytes.size()}, mode);
}

inline constexpr uint64_t kMostMemory = 64 << 20; // bytes; larger programs are refused

using common::need; // in packer/: `otherwise` is what makes a file unsuitable
inline constexpr char kDamaged[] = "damaged: get it afresh";
inline constexpr char kForeign[] = "not packed by this version of pack, or damaged at its beginning";

// What a program made for packing can rely on: one library, whose two functions find all others.
struct System {
    const char *library, *functions[2]; // open a library, and find a function in it
    const char *interpreter;            // null where there is none
};
inline constexpr System kLinux = {"libdl.so.2", {"dlopen", "dlsym"}, kInterpreter};
inline constexpr System kWindows = {"kernel32.dll", {"LoadLibraryA", "GetProcAddress"}, nullptr};

// The program in memory as it starts.
struct Program {
    uint32_t base;     // address of the first byte; page-aligned
    Bytes bytes;       // up to the last one that is not 0, at least one; the loader's tables are zeroed
    uint32_t readOnly; // bytes from base that are never written: code and constants; whole pages
    uint32_t span;     // bytes of memory, with the zeros behind the bytes
    uint32_t slots[2]; // addresses where it expects System::functions
    uint32_t entry;
    uint32_t early, earlyEntry;   // as in PayloadHeader
    uint32_t codeBegin, codeSize; // the stretch of `bytes` that is instructions

    // Leaves out zeros at the end of the bytes.
    void dropZeros() {
        while (bytes.size() > 1 && !bytes.back()) bytes.pop_back();
    }
    Layout layout() const { return {(uint32_t)bytes.size(), codeBegin, codeSize}; }
};

} // namespace pack
