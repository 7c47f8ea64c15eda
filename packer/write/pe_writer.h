// Makes executables for Windows (PE32+) from programs that were linked as ELF: same code, same addresses.
// Calls between the program and Windows use Microsoft's convention (ms_abi); everything else is as on Linux.
#pragma once

#include "packer/write/payload_section.h"
#include "packer/write/texts.h"

namespace pack {

// Bytes of stack of the main thread and of every thread that asks for no other size. All of it is committed,
// because code that was not compiled for Windows may step over the guard page that makes a stack grow.
constexpr uint64_t kPeStack = 1 << 20;

// An executable that lies in memory exactly like `program`, not packed: a section with its imports, one of
// code and constants, one of data. It is loaded at its address or not at all. Throws Unsuitable.
std::vector<uint8_t> writePlainPe(const Program &program);

// Packed, as pe_format.h says; `payload` encodes `program.bytes`. The others are as in elf_writer.h. All of
// them throw Unsuitable.
std::vector<uint8_t> writePackedPe(const Program &program, const ModelParameters &parameters,
                                   const std::vector<uint8_t> &payload, const Names &names = {});
size_t
overheadPe(const ModelParameters &parameters); // without the zeros that make the file a multiple of 512
std::vector<uint8_t> decodeWithStubPe(const std::vector<uint8_t> &packed);
bool isPe(const std::vector<uint8_t> &file);
Program readPackedPe(const std::vector<uint8_t> &file);

} // namespace pack
