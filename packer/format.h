// The packed file. To write another decoder one needs this page, decoder.h, model.h, fields.h, x86.h and
// opcodes.h.
//
// THE FILE is an executable (ELF, x86-64, ET_EXEC) whose parts follow each other without gaps; numbers are
// little-endian:
//
//     Front          528 bytes: ELF header, five program headers, the loader's tables
//     stub           machine code, the same in every file
//     PayloadHeader  46 bytes
//     masks          uint16_t: ModelParameters::masks[0] for code, then [1] for data: as many each as there
//                    are contexts, and kSets - 1 more
//     payload        the coded program, then zeros up to a multiple of four
//     check          four bytes
//
// The payload section is everything from PayloadHeader on; a packed file for Windows has the same section.
//
// Taken as words of 32 bits, the file makes checksum() 0; the check is chosen for that. Bytes behind
// PayloadHeader::words words do not belong to it. There are no section headers. The stub's size is not
// written anywhere: a reader knows the stub that it was made for.
//
// IN MEMORY the file is one R-X segment, kBelow bytes below the program. The program has one RW segment
// without bytes in the file, from PayloadHeader::image on, whole pages, so that it starts as zeros. The other
// headers are an interpreter, a dynamic section (needs libdl.so.2, imports dlopen and dlsym) and a stack that
// is not executable. The loader writes the two imports into the program's own slots, as the two relocations
// say, before it goes on at the first byte of the stub.
//
// START. The stub computes the checksum of the whole file. It first asks the kernel whether each page is
// there, because a file cut short lacks some. Then it maps PayloadHeader::memory bytes for the model, saves
// the two slots, decodes, restores the slots, makes PayloadHeader::readOnly bytes of the image R-X and unmaps
// the model's memory. It jumps to PayloadHeader::entry with rsp, rsi and rdx as the loader left them: the
// program sees argc, arguments, environment and, in rdx, what to call at exit. Nothing is writable and
// executable at once.
//
// IN TWO PHASES. If PayloadHeader::early is not kNothingEarly, the stub calls the function at
// PayloadHeader::earlyEntry before each byte whose offset in the image is a multiple of kEarlyStep and not
// less than `early`. Before each call it makes the first `early` bytes of the image R-X. The C calling
// convention applies: void (void **stack, uint32_t done, uint32_t size) gets the stack as the kernel made it
// (argc on top), bytes decoded, bytes in all. So the first call comes when `early` bytes are decoded; there
// is none if the image has no more bytes. The function's code and constants are among those bytes. What it
// writes must lie behind the last byte that is decoded, because decoding overwrites everything before. Its
// imports are in their slots only until `done` reaches these.
//
// THE PAYLOAD is the first Layout::size bytes of the image; those behind are zeros. Bytes follow each other
// from the first on, the bits of each from the highest down. Every bit is given to a range decoder (Decoder
// in decoder.h: 32 bits, range and code 1 and 0 at first, so that it begins by fetching three bytes) with a
// probability of 20 bits, which predict() in model.h makes of all bits before it; run() in decoder.h is the
// loop. It may fetch two bytes behind the payload, of padding or check, whose values do not matter. All
// state is zeros at first but the mixing weights. Floats are IEEE single precision, operations in the order
// written, each rounded to nearest, never fused; a float becomes an integer by truncation.
//
// Bytes from Layout::codeBegin on, Layout::codeSize of them, are code, the rest is data. Code has contexts
// of its own, and goes through the parser in x86.h, which starts at codeBegin as if an instruction did; in
// data the parser stands still, and the fields that it has left stay.
//
// ADDRESSES. After the byte at i the parser may say that a field of four bytes ends there which is relative
// to the next instruction. That begins at i + behind (one, plus one for each byte of an immediate operand to
// come). Then the bytes i - 3 .. i were coded as the offset of their target from the image's start, highest
// byte first. The program gets that offset less (i + behind), lowest byte first. Contexts and parser see the
// bytes as they were coded.
//
// ERRORS. A checksum that is not 0, or a missing page: "damaged: get it afresh"; no memory: "not enough
// free memory"; a system that lets nothing run that was written: "use odraz-safe instead" (another program's
// packer says another name here, in stub.S). All are one line on standard error, with exit status 1, and
// nothing of the program has run. What the check covers is trusted: behind it nothing is examined. It can
// guard neither the Front, which the loader reads first, nor its own 128 bytes of code.
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

// A symbol without the fields that the loader does not read for an imported one.
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

// What the stub must know. It begins the payload section, behind the stub's code.
struct PayloadHeader {
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
    uint8_t contexts;  // as in ModelParameters
    uint8_t slotShift; // 32 - ModelParameters::slotBits
} __attribute__((packed));
static_assert(sizeof(PayloadHeader) == 46);
constexpr uint32_t kNothingEarly = 0xffffffff;

// Over all words of the file. The last word makes this 0, so any changed word shows.
inline uint32_t checksum(const uint8_t *bytes, size_t words) {
    uint32_t sum = 0, word;
    for (; words--; bytes += 4) {
        __builtin_memcpy(&word, bytes, 4);
        sum = (sum + word) * kHash;
    }
    return sum;
}

// The masks as they follow the header.
inline std::vector<uint16_t> packMasks(const ModelParameters &parameters) {
    std::vector<uint16_t> all;
    for (auto &masks : parameters.masks) all.insert(all.end(), masks, masks + parameters.hashes());
    return all;
}

} // namespace pack
