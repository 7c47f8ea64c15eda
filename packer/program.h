// Programs: reading the one to pack, writing the packed one, and back.
#pragma once

#include "encoder.h"
#include "stub.h"

#include <stdexcept>
#include <string>

namespace pack {

inline constexpr uint64_t kMostMemory = 64 << 20; // no program of ours is larger

// What makes a file unsuitable, as one line for the user.
struct Unsuitable : std::runtime_error {
    using std::runtime_error::runtime_error;
};
inline void need(bool condition, const char *otherwise) {
    if (!condition) throw Unsuitable(otherwise);
}

// A program as it lies in memory when it starts.
struct Program {
    uint32_t base; // address of the first byte; page-aligned
    std::vector<uint8_t>
        bytes;         // up to the last one that is not 0, at least one; the loader's own tables are zeroed
    uint32_t readOnly; // bytes from base that are never written: code and constants; whole pages
    uint32_t span;     // bytes of memory, with the zeros behind the bytes
    uint32_t slots[2]; // addresses where it expects dlopen and dlsym
    uint32_t entry;
    uint32_t early, earlyEntry;   // as in Parameters
    uint32_t codeBegin, codeSize; // the stretch of `bytes` that is instructions

    Layout layout() const { return {(uint32_t)bytes.size(), codeBegin, codeSize}; }
};

// Accepts a fixed-base ET_EXEC for x86-64 with an interpreter, without RWX, TLS or constructors, that needs
// libdl.so.2 alone and imports only dlopen and dlsym, by GLOB_DAT, into slots side by side. A section
// `.early` at its start, ending on a page, is what Parameters calls the early part; its first byte is the
// function. Throws Unsuitable.
Program readProgram(const std::vector<uint8_t> &file);

// `payload` encodes `program.bytes`. The packed executable: header, tables, stub, parameters, payload,
// checksum. Throws Unsuitable.
std::vector<uint8_t> writePacked(const Program &program, const Shape &shape,
                                 const std::vector<uint8_t> &payload);

// Bytes of a packed file that are not payload.
size_t overhead(const Shape &shape);

// Runs the stub's own code on a packed file in memory, which writePacked has made.
std::vector<uint8_t> decodeWithStub(const std::vector<uint8_t> &packed);

// A packed file taken apart: the program but for its bytes, and how to decode them.
struct Packed {
    Program program;
    Layout layout;
    Shape shape;
    std::vector<uint8_t> payload;
};

// From any source. Throws Unsuitable.
Packed openPacked(const std::vector<uint8_t> &file);

// The same, and decoded with care.
Program readPacked(const std::vector<uint8_t> &file);

// An executable that lies in memory exactly like `program`, not packed.
std::vector<uint8_t> writePlain(const Program &program);

} // namespace pack
