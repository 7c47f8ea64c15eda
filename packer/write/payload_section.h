// The payload section: all that follows the stub in a packed file, on any system: header, masks, payload,
// padding and check, as format.h defines them.
#pragma once

#include "packer/model/encoder.h"
#include "packer/read/program.h"

namespace pack {

// A packed file taken apart: the program without its bytes, and how to decode them.
struct Packed {
    Program program;
    Layout layout;
    ModelParameters parameters;
    Bytes payload;
    uint32_t words; // of the file that the check covers
};

// Bytes of the section that are not payload.
size_t payloadSectionOverhead(const ModelParameters &parameters);

// Appends the section to what comes before, so that `out` has `size` bytes, and checksum() of those from
// `checkedFrom` on is 0.
void appendPayloadSection(Bytes &out, const Program &program, const ModelParameters &parameters,
                          const Bytes &payload, size_t checkedFrom, size_t size);

// Takes apart the section that begins at `from` in the file; its program takes `span` bytes of memory. Throws
// common::Refused if the section is damaged. The program's slots are in order of address; the caller
// assigns them to functions.
Packed openPayloadSection(const Bytes &file, size_t at, size_t checkedFrom, uint64_t span);

// Decodes the section at `at` with a stub's own code: stubDecode or stubDecodeWindows of stub.h.
using StubDecode = void(const uint8_t *header, uint8_t *image, void *memory);
Bytes decodePayloadSection(const Bytes &file, size_t at, StubDecode &decode);

} // namespace pack
