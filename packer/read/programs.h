// Reads the program to pack: one that was made for packing (elf_reader.cpp), or any (loader_reader.cpp). All
// throw common::Refused.
#pragma once

#include "packer/read/program.h"

namespace pack {

// Whether a program was made for the packer: of type ET_EXEC, with libdl.so.2 (or, for Windows, kernel32.dll)
// as its only library. readProgram() takes these, or throws the reason. Throws nothing.
bool isMadeForPacking(const Bytes &file);

// Accepts an x86-64 program of type ET_EXEC at a fixed base. It must have an interpreter, need libdl.so.2
// alone, and import only dlopen and dlsym, by GLOB_DAT, into adjacent slots. RWX segments, TLS and
// constructors are refused. Data must follow code and constants, on separate pages; everything must lie
// at 0x210000 or above, within 64 MiB. If there is a section `.early`, it must end at the end of a page. The
// image up to there is what PayloadHeader calls the early part, and the section's first byte is its function.
// For Windows the rules are the same, except that the program needs kernel32.dll alone, imports LoadLibraryA
// and GetProcAddress, and may have any interpreter or none.
Program readProgram(const Bytes &file, const System &system = kLinux);

// Accepts any x86-64 program that is static or names its interpreter, whose first segment begins with its ELF
// header, and whose program headers are in a segment. Refuses shared libraries, even those with an entry
// point. Of the result, readOnly and span are all its memory, in whole pages; it has no slots, and nothing
// early.
Program readAnyProgram(const Bytes &file);

// The number of bytes behind everything that the ELF headers name. They are not part of a packed program.
uint64_t appendedBytes(const Bytes &file);

} // namespace pack
