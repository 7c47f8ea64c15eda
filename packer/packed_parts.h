// What follows the stub in a packed file on any system: parameters, masks, payload, padding and check, as
// format.h has them.
#pragma once

#include "encoder.h"
#include "program.h"

namespace pack {

// A packed file taken apart: the program but for its bytes, and how to decode them.
struct Packed {
    Program program;
    Layout layout;
    Shape shape;
    std::vector<uint8_t> payload;
    uint32_t words; // of the file that the check covers
};

// The bytes that they take without the payload.
size_t partsSize(const Shape &shape);

// Appends them to all that comes before, so that `out` has `size` bytes and those from `checkedFrom` on make
// checksum() 0.
void appendParts(std::vector<uint8_t> &out, const Program &program, const Shape &shape,
                 const std::vector<uint8_t> &payload, size_t checkedFrom, size_t size);

// Takes them apart, which begin at `at`, of a program that takes `span` bytes of memory. Throws Unsuitable
// where they are damaged. The program's slots are the caller's.
Packed openParts(const std::vector<uint8_t> &file, size_t at, size_t checkedFrom, uint64_t span);

// Decodes them by a stub's own code: stubDecode of stub.h, or its like.
using StubDecode = void(const uint8_t *parameters, uint8_t *image, void *memory);
std::vector<uint8_t> decodeParts(const std::vector<uint8_t> &file, size_t at, StubDecode &decode);

} // namespace pack
