// The container: what a packed program consists of, shared by writer and reader. stub.S is the other party.
//
// A packed file is one R-X segment (ELF header, loader's tables, stub, parameters, payload, checksum) and one
// RW segment without file bytes at the program's own addresses. The loader writes dlopen and dlsym into the
// program's own slots before the stub runs; the stub keeps them across the decoding. The model's memory is
// mapped by the stub, and given back.
#pragma once

#include "decoder.h"

#include <vector>

namespace pack {

// Behind the stub's code; the masks follow, then the payload. Addresses fit in 32 bits: programs are linked
// low.
struct Parameters {
    uint32_t file;     // address the packed file is mapped to
    uint32_t words;    // its size in units of four bytes, all of which the checksum covers
    uint32_t image;    // address the program starts at; page-aligned
    uint32_t readOnly; // bytes from there that become R-X
    uint32_t imports;  // address of the slots of dlopen and dlsym, side by side in either order
    uint32_t entry;    // address to go on at
    // The part that starts while the rest is still being decoded: bytes from the image's start, whole pages
    // (kNothingEarly if there is none), and the address of its function,
    // void (void **stack, uint32_t done, uint32_t size). It is called from there on every 2 KB.
    uint32_t early, earlyEntry;
    Layout layout;
    uint32_t memory;   // bytes for the model
    uint8_t contexts;  // as in Shape
    uint8_t slotShift; // 32 - Shape::slotBits
} __attribute__((packed));
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

// The stub's own decoder, called with the parameters in front of masks and payload as they lie in a file.
// `memory`: Parameters::memory bytes of zeros, aligned to 16.
extern "C" void stubDecode(const uint8_t *parameters, uint8_t *image, void *memory);
extern "C" const uint32_t kStubMemory; // bytes in front of the slots
inline uint32_t stubMemory(const Shape &shape, uint32_t size) {
    return kStubMemory + ((uint32_t)sizeof(Slot) << shape.slotBits) + kPast + size;
}

} // namespace pack
