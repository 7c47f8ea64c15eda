// Packed programs of any kind: written, proved and opened. The format is in loader_format.h.
#pragma once

#include "packer/write/payload_section.h"
#include "packer/write/texts.h"

namespace pack {

// `payload` encodes the bytes of a program that readAnyProgram() has read. Throws Unsuitable.
std::vector<uint8_t> writePackedLoader(const Program &program, const ModelParameters &parameters,
                                       const std::vector<uint8_t> &payload, const Names &names = {});

// Bytes of a packed file that are not payload.
size_t overheadLoader(const ModelParameters &parameters);

// As those of elf_writer.h
std::vector<uint8_t> decodeWithStubLoader(const std::vector<uint8_t> &packed);
Program readPackedLoader(const std::vector<uint8_t> &file);

// Whether a file was packed so. It may be damaged, but its stub is whole.
bool isPackedLoader(const std::vector<uint8_t> &file);

// The program as an executable of its own, the same in memory, not packed.
std::vector<uint8_t> writePlainLoader(const Program &program);

} // namespace pack
