// The tables of a PE file (PE32+, x86-64), as far as packed programs use them. Names and values are those of
// Microsoft's "PE Format"; addresses in them (RVA) count from the image's base.
#pragma once

#include <cstdint>

namespace pack {

constexpr uint32_t kPeFileAlign = 512;       // of sections in the file
constexpr uint32_t kPeBaseAlign = 64 * 1024; // of an image's base

struct PeDirectory {
    uint32_t address, size;
};
enum PeDirectoryNumber { kPeImports = 1, kPeImportSlots = 12, kPeDirectories = 16 };

struct PeHeader {
    // For DOS
    uint16_t dosMagic; // "MZ"
    uint8_t dos[58];
    uint32_t headerAt; // of `signature` in the file

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
    uint32_t names; // address of the table of imported names; 0: the slots themselves hold it at first
    uint32_t time, forwarder, library, slots;
};
static_assert(sizeof(PeImports) == 20);

} // namespace pack
