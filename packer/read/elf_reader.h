// Reads the program to pack.
#pragma once

#include "packer/read/program.h"

namespace pack {

// Accepts an x86-64 program of type ET_EXEC at a fixed base. It must have an interpreter, need libdl.so.2
// alone, and import only dlopen and dlsym, by GLOB_DAT, into adjacent slots. RWX segments, TLS and
// constructors are refused. Data must follow code and constants, on separate pages; everything must lie
// at 0x210000 or above, within 64 MiB. If there is a section `.early`, it must end at the end of a page. The
// image up to there is what PayloadHeader calls the early part, and the section's first byte is its function.
// For Windows the rules are the same, except that the program needs kernel32.dll alone, imports LoadLibraryA
// and GetProcAddress, and may have any interpreter or none. Throws common::Refused.
Program readProgram(const Bytes &file, const System &system = kLinux);

} // namespace pack
