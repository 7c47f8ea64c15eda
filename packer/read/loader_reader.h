// Reads programs of any kind.
#pragma once

#include "packer/read/program.h"

namespace pack {

// Whether a program was made for the packer: of type ET_EXEC, with libdl.so.2 (or, for Windows, kernel32.dll)
// as its only library. readProgram() takes these, or throws the reason. Throws nothing.
bool isMadeForPacking(const Bytes &file);

// Accepts any x86-64 program that is static or names its interpreter, whose first segment begins with its ELF
// header, and whose program headers are in a segment. Refuses shared libraries, even those with an entry
// point. Of the result, readOnly and span are all its memory, in whole pages; it has no slots, and nothing
// early. Throws common::Refused.
Program readAnyProgram(const Bytes &file);

// The number of bytes behind everything that the ELF headers name. They are not part of a packed program.
uint64_t appendedBytes(const Bytes &file);

} // namespace pack
