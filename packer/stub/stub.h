// The decoders of stub.S, stub_windows.S and stub_loader.S as functions: the packer runs them on packed
// files.
#pragma once

#include "packer/stub/loader_format.h"
#include "packer/stub/pe_format.h"

namespace pack {

// These functions do the same as codeImage() in decoder.h. `header`: the PayloadHeader in a file, with
// everything that follows it. `image`: Layout::size bytes. `memory`: stubMemory() bytes of zeros,
// page-aligned.
extern "C" void stubDecode(const uint8_t *header, uint8_t *image, void *memory);
extern "C" void stubDecodeWindows(const uint8_t *header, uint8_t *image, void *memory);
extern "C" void stubDecodeLoader(const uint8_t *header, uint8_t *image, void *memory);

extern "C" const uint32_t kStubMemory; // bytes of the model before the slots
inline uint32_t stubMemory(const ModelParameters &parameters, uint32_t size) {
    return kStubMemory + (uint32_t)memoryAfterModel(parameters, size);
}

} // namespace pack
