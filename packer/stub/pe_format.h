// The packed file for Windows. Payload section and decoding are as in format.h. This file describes the bytes
// before that section, and how the program starts.
//
// THE FILE is an executable (PE32+ for x86-64) with a fixed address:
//
//     PeFront        512 bytes: headers, two sections, messages
//     PeStart        the imports; they begin the first section
//     stub           machine code, the same in every file
//     PayloadHeader, masks, payload, zeros up to a multiple of 512 less four bytes, check
//
// IN MEMORY the headers take a page at the image's base. The first section follows; it is R-X and extends to
// the program. The second section is the program; it is RW and has no bytes in the file. The check is chosen
// so that checksum() over the first section, from the end of the slots on, is 0. PayloadHeader::words is the
// number of words that the checksum covers. The stub computes this number from the section's size instead,
// which the loader has checked.
//
// START. The loader writes the addresses of the imported functions into the slots, and calls the stub's first
// byte in Microsoft's convention. The first two slots are for LoadLibraryA and GetProcAddress, in the
// order that the program's own slots have. The stub computes the checksum, allocates PayloadHeader::memory
// bytes, copies the two slots to the program's own slots, decodes, copies them again (decoding overwrites
// them), makes PayloadHeader::readOnly bytes R-X, frees the memory and jumps to PayloadHeader::entry with the
// stack as it found it. The function at PayloadHeader::earlyEntry is called as in format.h, in System V's
// convention; its first argument has no meaning here.
//
// ERRORS go to standard error or, if there is none, to a message box; the exit status is 1.
#pragma once

#include "packer/stub/format.h"

#include <cstdint>

namespace pack {

// --- The tables of a PE file (PE32+, x86-64), as far as packed programs use them. Names and values come from
// Microsoft's "PE Format"; addresses in them (RVA) count from the image's base ---

constexpr uint32_t kPeFileAlign = 512;       // alignment of sections in the file
constexpr uint32_t kPeBaseAlign = 64 * 1024; // alignment of an image's base

struct PeDirectory {
    uint32_t address, size;
};
enum PeDirectoryNumber { kPeImports = 1, kPeImportSlots = 12, kPeDirectories = 16 };

struct PeHeader {
    // For DOS
    uint16_t dosMagic; // "MZ"
    uint8_t dos[58];
    uint32_t headerAt; // offset of `signature` in the file

    uint32_t signature; // "PE"
    uint16_t machine, sections;
    uint32_t time, symbols, symbolCount;
    uint16_t optionalSize, flags;

    uint16_t magic;
    uint8_t linker[2];
    uint32_t codeSize, dataSize, zeroSize, entry, codeAt;
    uint64_t base;
    uint32_t sectionAlign, fileAlign;
    uint16_t system[2], version[2], subsystemVersion[2];
    uint32_t reserved, imageSize, headerSize, checksum;
    uint16_t subsystem, dllFlags;
    uint64_t stackReserve, stackCommit, heapReserve, heapCommit;
    uint32_t loaderFlags, directoryCount;
    PeDirectory directories[kPeDirectories];
};
static_assert(sizeof(PeHeader) == 64 + 24 + 112 + 8 * kPeDirectories);

enum PeSectionFlags : uint32_t {
    kPeCode = 0x60000020,  // instructions; read, execute
    kPeConst = 0x40000040, // initialised; read
    kPeData = 0xc0000040,  // initialised; read, write
    kPeZeros = 0xc0000080, // not initialised; read, write
};
struct PeSection {
    char name[8];
    uint32_t memorySize, address, fileSize, fileAt;
    uint32_t unused[3];
    uint32_t flags;
};
static_assert(sizeof(PeSection) == 40);

struct PeImports {
    uint32_t names; // address of the table of imported names; 0: the slots hold it until they are filled
    uint32_t time, forwarder, library, slots;
};
static_assert(sizeof(PeImports) == 20);

// --- The packed file ---

// The stub's messages (packed_file.h), and two names: the function that shows a message box, and its library.
// They fill space that would be empty.
struct PeMessages {
    char mayNotRun[24], damaged[24], noMemory[24], user32[7], messageBox[25];
};

struct PeFront {
    PeHeader header;
    PeSection sections[2];
    PeMessages messages;
};
static_assert(sizeof(PeFront) == kPeFileAlign);

// The imports by slot: two for the program, in the order of its own slots, then the stub's.
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

// The beginning of the first section. Slots hold the addresses of names until the loader fills them.
struct PeStart {
    uint64_t slots[kPeImportCount + 1];
    PeImports library, end;
    char names[120], libraryName[16];
};
static_assert(sizeof(PeStart) % 4 == 0);

} // namespace pack
