// The stub as the packer runs it: the decoder in stub.S, stub_windows.S and stub_loader.S, called with what a
// packed file contains. Also checks that the numbers in stub_numbers.h, which the assembler
// uses, equal those of C++.
#pragma once

#include "packer/stub/loader_format.h"
#include "packer/stub/pe_format.h"

#include <bit>

namespace pack {

// What run() in decoder.h does. `header`: a PayloadHeader as it lies in a file, with what follows it.
// `image`: Layout::size bytes. `memory`: stubMemory() bytes of zeros, page-aligned.
extern "C" void stubDecode(const uint8_t *header, uint8_t *image, void *memory);
extern "C" void stubDecodeWindows(const uint8_t *header, uint8_t *image, void *memory);
extern "C" void stubDecodeLoader(const uint8_t *header, uint8_t *image, void *memory);

extern "C" const uint32_t kStubMemory; // bytes in front of the slots
inline uint32_t stubMemory(const ModelParameters &parameters, uint32_t size) {
    return kStubMemory + (uint32_t)memoryBehindModel(parameters, size);
}

namespace stub {

constexpr int64_t bits(float value) { return std::bit_cast<uint32_t>(value); }

enum Number : int64_t {
#define STUB_NUMBER(name, value, meaning) name = value,
#include "packer/stub/stub_numbers.h"
};
#define STUB_NUMBER(name, value, meaning) static_assert((int64_t)(value) == (int64_t)(meaning), #name);
#include "packer/stub/stub_numbers.h"

} // namespace stub

} // namespace pack
