// The container: what a packed program consists of, shared by the packer and the stub that unpacks it.
//
// A packed file is one R-X segment (ELF header, loader's tables, stub, parameters, payload) and one RW
// segment without file bytes that spans the program's own addresses and, behind them, the model's memory. The
// loader writes dlopen and dlsym into the program's own slots before the stub runs; the stub keeps them
// across the decoding.
#pragma once

#include <stdint.h>

namespace pack {

// Behind the stub's code in the file. Addresses fit in 32 bits: programs are linked low.
struct Parameters {
    uint32_t payload;   // address of the coded bytes
    uint32_t image;     // address the program starts at; page-aligned
    uint32_t imageSize; // bytes to decode
    uint32_t codeSize;  // of these, bytes that become R-X and went through the address filter
    uint32_t limit;     // span of the program in memory, with its zeros: what addresses point into
    uint32_t model;     // address of the model's memory; page-aligned
    uint32_t slots[2];  // addresses of the slots of dlopen and dlsym
    uint32_t entry;     // address to go on at
};

} // namespace pack
