// The packed file for Windows. The payload section and its decoding are those of format.h; this page
// describes what comes before that section, and how the program starts.
//
// THE FILE is an executable (PE32+ for x86-64) with a fixed address:
//
//     PeFront        512 bytes: headers, two sections, messages
//     PeStart        begins the first section: what is imported
//     stub           machine code, the same in every file
//     PayloadHeader, masks, payload, zeros up to a multiple of 512 less four bytes, check
//
// IN MEMORY the headers take a page at the image's base. The first section follows; it is R-X and reaches up
// to the program. The second section is the program's; it is RW and has no bytes in the file. The check makes
// checksum() 0 over everything in the first section after the slots; PayloadHeader::words is the number of
// those words. The stub does not use that number but the section's size, which the loader has checked.
//
// START. The loader writes the addresses of the imported functions into the slots, and calls the first byte
// of the stub by Microsoft's convention. The first two slots are for LoadLibraryA and GetProcAddress, in the
// order of the program's own slots. The stub computes the checksum, allocates PayloadHeader::memory bytes,
// copies the two slots to the program's, decodes, copies them again (decoding overwrites them), makes
// PayloadHeader::readOnly bytes R-X, frees the memory and jumps to PayloadHeader::entry with the stack as it
// found it. The function at PayloadHeader::earlyEntry is called as in format.h, by System V's convention; its
// first argument has no meaning here.
//
// ERRORS go to standard error or, if there is none, to a message box; the exit status is 1.
#pragma once

#include "packer/stub/format.h"
#include "packer/stub/pe_file.h"

namespace pack {

// The stub's messages (messages.h), and the names of the function that shows a box and its library. They fill
// space that the file has anyway.
struct PeMessages {
    char mayNotRun[24], damaged[24], noMemory[24], user32[7], messageBox[25];
};

struct PeFront {
    PeHeader header;
    PeSection sections[2];
    PeMessages messages;
};
static_assert(sizeof(PeFront) == kPeFileAlign);

// The imports, slot by slot: two for the program, in the order of its own slots, then the stub's.
enum PeImport {
    kPeProgram1,
    kPeProgram2,
    kPeLoadLibrary,
    kPeGetProcAddress,
    kPeVirtualAlloc,
    kPeVirtualFree,
    kPeVirtualProtect,
    kPeGetStdHandle,
    kPeWriteFile,
    kPeExitProcess,
    kPeImportCount
};

// The first section begins with this. Slots hold the addresses of names until the loader fills them.
struct PeStart {
    uint64_t slots[kPeImportCount + 1];
    PeImports library, end;
    char names[120], libraryName[16];
};
static_assert(sizeof(PeStart) % 4 == 0);

} // namespace pack
