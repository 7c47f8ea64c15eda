// Reads the program to pack: one that was made for packing (elf_reader.cpp), or any program
// (loader_reader.cpp). Both throw common::Refused.
#pragma once

#include "packer/read/program.h"

namespace pack {

// Whether a program was made for the packer: its type is ET_EXEC, and libdl.so.2 (or, for Windows,
// kernel32.dll) is its only library. Such programs are read by readProgram(). Throws nothing.
bool isMadeForPacking(const Bytes &file);

// Accepts an x86-64 program of type ET_EXEC at a fixed base. It must have an interpreter, need only
// libdl.so.2, and import only dlopen and dlsym, by GLOB_DAT, into adjacent slots. It must not have RWX
// segments, TLS or constructors. Data must follow code and constants, on separate pages. All addresses must
// be 0x210000 or above, within 64 MiB. No section may follow a section `.early` in its last page: the image
// up to the end of that page is the early part (PayloadHeader::early), whose function is the section's first
// byte. For Windows the program needs only kernel32.dll instead, imports LoadLibraryA and GetProcAddress, and
// may have any interpreter or none.
Program readProgram(const Bytes &file, const System &system = kLinux);

// Accepts any x86-64 program that is static or names its interpreter. Its first segment must begin with its
// ELF header, and its program headers must be in a segment. Refuses shared libraries. In the result, readOnly
// and span are the size of all its memory, in whole pages. It has no slots and no early part.
Program readAnyProgram(const Bytes &file);

// Returns the number of bytes after the last one that the ELF headers name. A packed program lacks these
// bytes.
uint64_t appendedBytes(const Bytes &file);

} // namespace pack
