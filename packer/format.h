// The container: what a packed program consists of, shared by writer and reader. stub.S is the other party.
//
// A packed file is one R-X segment (ELF header, loader's tables, stub, parameters, payload, checksum) and one
// RW segment without file bytes at the program's own addresses. The loader writes dlopen and dlsym into the
// program's own slots before the stub runs; the stub keeps them across the decoding. The model's memory is
// mapped by the stub, and given back.
#pragma once

#include "decoder.h"

#include <elf.h>
#include <vector>

namespace pack {

inline constexpr char kInterpreter[] = "/lib64/ld-linux-x86-64.so.2";
inline constexpr uint64_t kPage = 4096;
constexpr uint64_t wholePages(uint64_t bytes) { return (bytes + kPage - 1) & ~(kPage - 1); }
constexpr uint32_t kBelow = 0x200000;             // the file lies so far below the program, and is no larger
constexpr uint32_t kLeastBase = kBelow + 0x10000; // of a program: the kernel maps nothing below 64 KB
constexpr uint64_t kAddressEnd = 0x7fffffff;      // of all: programs are linked for addresses of 31 bits
constexpr uint32_t kEarlyStep = 2048;             // bytes from call to call of the early part, a power of two

// A symbol without what the loader does not read of one that is imported.
struct Import {
    uint32_t name;
    uint8_t info, other;
    uint16_t section;
};

// Everything in front of the stub. Tables overlap where the loader does not look: of the segment GNU_STACK it
// reads type and flags, of an imported symbol not the value; the null symbol is never read (the symbol table
// begins before `first`), of the dynamic section's end only the tag.
struct Front {
    Elf64_Ehdr header;
    Elf64_Phdr segments[4]; // INTERP, LOAD of the file, LOAD of the program, DYNAMIC
    uint32_t stackType, stackFlags;
    char interpreter[sizeof kInterpreter], functions[20]; // in place of the rest of GNU_STACK
    Elf64_Dyn dynamic[6];
    uint64_t dynamicEnd;
    Import first;
    char library[16];
    Import second;
    Elf64_Rela relocations[2]; // dlopen, dlsym
};
static_assert(sizeof(Front) == 528 && offsetof(Front, dynamic) % 8 == 0);

// Behind the stub's code; the masks follow, then the payload.
struct Parameters {
    uint32_t file;     // address the packed file is mapped to
    uint32_t words;    // its size in units of four bytes, all of which the checksum covers
    uint32_t image;    // address the program starts at; page-aligned
    uint32_t readOnly; // bytes from there that become R-X; whole pages
    uint32_t imports;  // address of the slots of dlopen and dlsym, side by side in either order
    uint32_t entry;    // address to go on at
    // The part that starts while the rest is still being decoded: bytes from the image's start, whole pages,
    // or kNothingEarly; and the address of its function
    uint32_t early, earlyEntry;
    Layout layout;
    uint32_t memory;   // bytes that the stub needs for the model; another decoder may need others
    uint8_t contexts;  // as in Shape
    uint8_t slotShift; // 32 - Shape::slotBits
} __attribute__((packed));
static_assert(sizeof(Parameters) == 50);
constexpr uint32_t kNothingEarly = 0xffffffff;

// Over all words of the file, of which the last is chosen so that this is 0: any changed word shows.
inline uint32_t checksum(const uint8_t *bytes, size_t words) {
    uint32_t sum = 0, word;
    for (; words--; bytes += 4) {
        __builtin_memcpy(&word, bytes, 4);
        sum = (sum + word) * kHash;
    }
    return sum;
}

// The masks as they follow the parameters.
inline std::vector<uint16_t> packMasks(const Shape &shape) {
    std::vector<uint16_t> all;
    for (auto &masks : shape.masks) all.insert(all.end(), masks, masks + shape.hashes());
    return all;
}

} // namespace pack
