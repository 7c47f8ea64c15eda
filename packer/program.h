// Reading the program to pack, and writing the packed one.
#pragma once

#include "format.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace pack {

inline constexpr char kInterpreter[] = "/lib64/ld-linux-x86-64.so.2";
inline constexpr uint64_t kPage = 4096;
inline constexpr uint64_t wholePages(uint64_t bytes) { return (bytes + kPage - 1) & ~(kPage - 1); }

// What makes a file unsuitable, as one line for the user.
struct Unsuitable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A program as it lies in memory when it starts.
struct Program {
    uint32_t base;              // address of the first byte; page-aligned
    std::vector<uint8_t> bytes; // up to the last byte that the file gives; the loader's own tables are zeroed
    uint32_t codeSize;          // bytes from base that are never written: code and constants; whole pages
    uint32_t span;              // bytes of memory, with the zeros behind the bytes
    uint32_t slots[2];          // addresses where it expects dlopen and dlsym
    uint32_t entry;
};

// Accepts a fixed-base ET_EXEC for x86-64 with an interpreter, without RWX, TLS or constructors, that needs
// libdl.so.2 alone and imports only dlopen and dlsym, by GLOB_DAT. Throws Unsuitable.
Program readProgram(const std::vector<uint8_t> &file);

// The packed executable: header, tables, stub, parameters and payload.
std::vector<uint8_t> writePacked(const Program &program, const std::vector<uint8_t> &payload);

// Bytes of a packed file that are not payload.
size_t overhead();

} // namespace pack
