// The packed file for Windows. The payload section and its decoding are those of format.h; here is what lies
// in front of that section, and how the program starts.
//
// THE FILE is an executable (PE32+ for x86-64) of a fixed address:
//
//     PeFront        512 bytes: headers, two sections, texts
//     PeStart        begins the first section: what is imported
//     stub           machine code, the same in every file
//     PayloadHeader, masks, payload, zeros up to a multiple of 512 less four bytes, check
//
// IN MEMORY the headers have a page at the image's base; the first section follows, read and execute, and
// reaches up to the program; the second is the program's, read and write, without bytes in the file. Of the
// first section all that comes behind the slots makes checksum() 0; PayloadHeader::words says how many words
// that are. The stub does not look there, but in the section's own size, which the loader has checked.
//
// START. The loader writes the addresses of what is imported into the slots, those of LoadLibraryA and
// GetProcAddress first, in the order in which the program wants them, and calls the first byte of the stub
// by Microsoft's convention. It computes the checksum, takes PayloadHeader::memory bytes, copies the two
// slots to the program's, decodes, copies them again, makes PayloadHeader::readOnly bytes R-X, gives the
// memory back and jumps to PayloadHeader::entry with the stack as it found it. The function at
// PayloadHeader::earlyEntry is called as in format.h, by System V's convention; its first argument says
// nothing here.
//
// ERRORS go to standard error, and where there is none, to a box; the exit status is 1.
#pragma once

#include "format.h"
#include "pe_file.h"

namespace pack {

// What the stub says, and in what box: where the file has room all the same.
struct PeTexts {
    char guarded[24] = "use odraz-safe instead\n", damaged[24] = "damaged: get it afresh\n",
         noMemory[24] = "not enough free memory\n", user32[7] = "user32", messageBox[25] = "MessageBoxA";
};

struct PeFront {
    PeHeader header;
    PeSection sections[2];
    PeTexts texts;
};
static_assert(sizeof(PeFront) == kPeFileAlign);

// What is imported, slot by slot: two for the program, in the order in which it wants them, and the stub's
// own.
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

// The first section begins with it. Slots hold the addresses of names until the loader fills them.
struct PeStart {
    uint64_t slots[kPeImportCount + 1];
    PeImports library, end;
    char names[120], libraryName[16];
};
static_assert(sizeof(PeStart) % 4 == 0);

} // namespace pack
