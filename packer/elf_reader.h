// Reading the program to pack.
#pragma once

#include "program.h"

namespace pack {

// Accepts a fixed-base ET_EXEC for x86-64 with an interpreter, without RWX, TLS or constructors, that needs
// libdl.so.2 alone and imports only dlopen and dlsym, by GLOB_DAT, into slots side by side. Data lie behind
// code and constants, on pages of their own; all of it at 0x210000 or above, within 64 MiB. A section
// `.early` ends on a page of its own: what lies in front of that end is what Parameters calls the early part,
// the section's first byte the function. For Windows: the same, but that it needs kernel32.dll alone, imports
// LoadLibraryA and GetProcAddress, and may have any interpreter or none. Throws Unsuitable.
Program readProgram(const std::vector<uint8_t> &file, const System &system = kLinux);

} // namespace pack
