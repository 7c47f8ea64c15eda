// The packed file. To write another decoder, you need this file, decoder.h, model.h, fields.h, x86_tracker.h,
// x86.h and opcodes.h.
//
// THE FILE is an executable (ELF, x86-64, ET_EXEC). Its parts follow one another without gaps; numbers are
// little-endian:
//
//     Front          528 bytes: ELF header, five program headers, the loader's tables
//     stub           machine code, the same in every file
//     PayloadHeader  46 bytes
//     masks          ModelParameters::masks[0] for code, two bytes each, without the kCodeShift lowest
//                    bits; then masks[1] for data, one byte each. Each array has contexts + kSets - 1 masks
//     payload        the coded program, then zeros up to a multiple of four
//     check          four bytes
//
// The payload section is everything from PayloadHeader on; a packed file for Windows has the same.
//
// The check is chosen so that checksum() over the file, read as 32-bit words, is 0. Bytes after the first
// PayloadHeader::words words do not belong to the file. There are no section headers. The stub's size is not
// stored: a reader must have the stub that the file was made with.
//
// IN MEMORY the file is one R-X segment that starts kBelow bytes below the program. The program is one RW
// segment of whole pages from PayloadHeader::image on. It has no bytes in the file, so it starts as zeros.
// The other program headers are for the interpreter, for a dynamic section (which needs libdl.so.2 and
// imports dlopen and dlsym) and for a stack that is not executable. The two relocations make the loader write
// the addresses of the imports into the program's own slots. Then it jumps to the first byte of the stub.
//
// START. The stub computes the checksum of the whole file. A truncated file lacks some pages, so the stub
// asks the kernel whether a page is there before it reads it. Then it maps PayloadHeader::memory bytes for
// the model, saves the two slots, decodes, restores the slots, makes PayloadHeader::readOnly bytes of the
// image R-X and unmaps the model's memory. Finally it jumps to PayloadHeader::entry with rsp, rsi and rdx as
// the loader left them: the program gets argc, the arguments, the environment and, in rdx, the function to
// call at exit. No memory is ever writable and executable at once.
//
// IN TWO PHASES. If PayloadHeader::early is not kNothingEarly, the stub calls the function at
// PayloadHeader::earlyEntry before it decodes each byte whose offset in the image is a multiple of kEarlyStep
// and at least `early`. Before each call it makes the first `early` bytes of the image R-X. The function is
// void (void **stack, uint32_t done, uint32_t size), in the C calling convention. Its arguments are the stack
// as the kernel made it (argc on top), the number of bytes decoded so far, and the number of bytes in all.
// An image of at most `early` bytes causes no call. The function's code and constants must be within the
// first `early` bytes. What it writes must be after the last byte that is decoded. The imports stay in their
// slots only until decoding reaches the slots.
//
// THE PAYLOAD decodes to the first Layout::size bytes of the image, in order; the bytes after them are zeros.
// The bits of a byte come from the highest to the lowest, each from a range decoder (Decoder in decoder.h: 32
// bits; range and code start as 1 and 0, so it begins by fetching three bytes). It needs a probability of 20
// bits, which predict() in model.h computes from all earlier bits; codeImage() in decoder.h is the loop. It
// may fetch two bytes beyond the payload, of the padding or the check; their values have no effect. All of
// the model's state starts as zeros, except the mixing weights. Floats are IEEE single precision. Operations
// are done in the order written, each rounded to nearest, never fused. A float is converted to an integer by
// truncation.
//
// The Layout::codeSize bytes from Layout::codeBegin on are code; the rest is data. Both have their own
// contexts. Only code goes through the parser in x86.h, which assumes that an instruction begins at
// codeBegin. In data the parser does not advance, and the fields that it has set keep their values.
//
// ADDRESSES. After byte i the parser may report the end of a four-byte field that is relative to the next
// instruction. That instruction begins at i + toNext, where toNext is one plus the size of an immediate
// operand still to come. Then bytes i - 3 .. i were coded as the target's offset from the image's start,
// highest byte first. In the program they are that offset less (i + toNext), lowest byte first. Contexts and
// parser use the bytes as they were coded. One-byte fields, which the parser also reports, are coded
// unchanged.
//
// ERRORS. If the checksum is not 0 or a page is missing, the stub prints "damaged: copy it again"; if it gets
// no memory, "not enough free memory"; if the system forbids executing memory that was written, "it may not
// run packed", or the program to use instead (packed_file.h). A message is one line on standard error; the
// exit status is 1, and nothing of the program has run. The stub checks nothing else. The checksum cannot
// protect the Front, which the loader reads first, or the 128 bytes that compute it.
#pragma once

#include "packer/model/decoder.h"

#include <elf.h>

namespace pack {

inline constexpr char kInterpreter[] = "/lib64/ld-linux-x86-64.so.2";
inline constexpr uint64_t kPage = 4096;
constexpr uint64_t wholePages(uint64_t bytes) { return (bytes + kPage - 1) & ~(kPage - 1); }
constexpr uint32_t kBelow = 0x200000; // the file is mapped this far below the program; also its largest size
constexpr uint32_t kLeastBase = kBelow + 0x10000; // lowest base, since the kernel maps nothing below 64 KB
constexpr uint64_t kAddressEnd = 0x7fffffff;      // limit of all addresses, which have 31 bits
constexpr uint32_t kEarlyStep = 2048;             // bytes between two calls of the early part, a power of two

// A symbol, without its last fields, which the loader does not read for an import.
struct Import {
    uint32_t name;
    uint8_t info, other;
    uint16_t section;
};

// Everything before the stub. Tables overlap where the loader reads nothing. It reads only type and flags of
// the segment GNU_STACK, only the tag of the dynamic section's end, and not the value of an imported symbol.
// It never reads the null symbol, so the symbol table begins before `first`.
struct Front {
    Elf64_Ehdr header;
    Elf64_Phdr segments[4]; // INTERP, LOAD of the file, LOAD of the program, DYNAMIC
    uint32_t stackType, stackFlags;
    char interpreter[sizeof kInterpreter], functions[20]; // in place of the other fields of GNU_STACK
    Elf64_Dyn dynamic[6];
    uint64_t dynamicEnd;
    Import first;
    char library[16];
    Import second;
    Elf64_Rela relocations[2]; // dlopen, dlsym
};
static_assert(sizeof(Front) == 528 && offsetof(Front, dynamic) % 8 == 0);

// The stub's parameters. This header begins the payload section, right after the stub's code.
struct PayloadHeader {
    uint32_t words;    // 32-bit words that the checksum covers: in an ELF file all of them
    uint32_t image;    // address of the program's first byte; page-aligned
    uint32_t readOnly; // bytes from `image` on that become R-X; whole pages
    uint32_t imports;  // address of the two adjacent slots for dlopen and dlsym, in either order
    uint32_t entry;    // address to jump to when all is decoded
    // The early part runs while the rest is still being decoded. `early`: its size in bytes from the image's
    // start, whole pages, or kNothingEarly. `earlyEntry`: the address of its function
    uint32_t early, earlyEntry;
    Layout layout;
    uint32_t memory;   // bytes of the stub's model; another decoder may need more or fewer
    uint8_t contexts;  // as in ModelParameters
    uint8_t slotShift; // 32 - ModelParameters::slotBits
} __attribute__((packed));
static_assert(sizeof(PayloadHeader) == 46);
constexpr uint32_t kNothingEarly = 0xffffffff;

// Returns the checksum of all words of the file: 0, by the choice of the last word. A change of any one word
// changes it.
inline uint32_t checksum(const uint8_t *bytes, size_t words) {
    uint32_t sum = 0, word;
    for (; words--; bytes += 4) {
        __builtin_memcpy(&word, bytes, 4);
        sum = (sum + word) * kHash;
    }
    return sum;
}

constexpr size_t kCodeMask = kCodeBits / 8, kDataMask = kDataBits / 8; // bytes of a mask in the file

} // namespace pack
