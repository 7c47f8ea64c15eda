// Packed programs: written, proved, opened, and made plain again. The format is in format.h.
#pragma once

#include "packer/write/payload_section.h"
#include "packer/write/texts.h"

namespace pack {

// `payload` encodes `program.bytes`. Throws Unsuitable.
std::vector<uint8_t> writePacked(const Program &program, const ModelParameters &parameters,
                                 const std::vector<uint8_t> &payload, const Names &names = {});

// Bytes of a packed file that are not payload.
size_t overhead(const ModelParameters &parameters);

// Runs the stub's own code on a packed file in memory, which writePacked() must have made. Returns the
// decoded bytes.
std::vector<uint8_t> decodeWithStub(const std::vector<uint8_t> &packed);

// Whether a file was packed so. It may be damaged, but its stub is whole.
bool isPacked(const std::vector<uint8_t> &file);

// Takes a packed file apart, but does not decode it. The file may come from any source. Throws Unsuitable.
Packed openPacked(const std::vector<uint8_t> &file);

// Does the same, and decodes without reading beyond the payload. Throws Unsuitable.
Program readPacked(const std::vector<uint8_t> &file);

// An executable that lies in memory exactly like `program`, not packed.
std::vector<uint8_t> writePlain(const Program &program);

} // namespace pack
