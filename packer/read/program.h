// A program in memory, its file, and how it is read.
#pragma once

#include "packer/model/encoder.h"
#include "packer/stub/format.h"
#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace pack {

// Reads a whole file. Errors are thrown as in tools/common/whole_file.h
inline Bytes readBytes(const std::string &path) {
    const std::string file = common::readWhole(path);
    return {file.begin(), file.end()};
}

// Returns the permissions of a file, in chmod's form.
inline unsigned modeOf(const std::string &path) {
    return (unsigned)std::filesystem::status(path).permissions() & 0777;
}

inline void writeBytes(const std::string &path, const Bytes &bytes, unsigned mode = 0) {
    common::writeWhole(path, {(const char *)bytes.data(), bytes.size()}, mode);
}

inline constexpr uint64_t kMostMemory = 64 << 20; // bytes; larger programs are refused

using common::need; // in packer/, the text is the reason why a file is refused
inline constexpr char kDamaged[] = "damaged: copy it again";
inline constexpr char kForeign[] = "not packed by this version of pack, or damaged at its beginning";

// The system of a program made for packing: one library, whose two functions find all others.
struct System {
    const char *library, *functions[2]; // the functions open a library, and find a function in it
    const char *interpreter;            // null: none
};
inline constexpr System kLinux = {"libdl.so.2", {"dlopen", "dlsym"}, kInterpreter};
inline constexpr System kWindows = {"kernel32.dll", {"LoadLibraryA", "GetProcAddress"}, nullptr};

// The program in memory as it starts.
struct Program {
    uint32_t base;     // address of the first byte; page-aligned
    Bytes bytes;       // up to the last byte that is not 0, but at least one; the loader's tables are zeroed
    uint32_t readOnly; // size of code and constants, from the base on; whole pages
    uint32_t span;     // bytes of memory, including the zeros after `bytes`
    uint32_t slots[2]; // addresses of the slots for System::functions
    uint32_t entry;
    uint32_t early, earlyEntry;   // as in PayloadHeader
    uint32_t codeBegin, codeSize; // the part of `bytes` that is instructions

    // Removes zeros at the end of the bytes.
    void dropZeros() {
        while (bytes.size() > 1 && !bytes.back()) bytes.pop_back();
    }
    Layout layout() const { return {(uint32_t)bytes.size(), codeBegin, codeSize}; }
};

// --- The readers. They throw common::Refused ---

// Whether a program was made for the packer, so that readProgram() reads it: its type is ET_EXEC, and
// libdl.so.2 (or, for Windows, kernel32.dll) is its only library. Throws nothing.
bool isMadeForPacking(const Bytes &file);

// Accepts the programs that packer/README.md describes (Requirements). Its early part (PayloadHeader::early)
// ends with the last page of the section `.early`, and the function is the section's first byte.
Program readProgram(const Bytes &file, const System &system = kLinux);

// Accepts any x86-64 program that is static or names its interpreter. Its first segment must begin with its
// ELF header, and its program headers must be in a segment. Refuses shared libraries. In the result, readOnly
// and span are the size of all its memory, in whole pages. It has no slots and no early part.
Program readAnyProgram(const Bytes &file);

// Returns the number of bytes after the last one that the ELF headers name. A packed program lacks them.
uint64_t appendedBytes(const Bytes &file);

} // namespace pack
