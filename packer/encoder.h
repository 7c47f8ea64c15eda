// Encoding a program's bytes, with the decoder's own model.
#pragma once

#include "decoder.h"

#include <cstdlib>
#include <memory>
#include <vector>

namespace pack {

// Zeroed memory for the model, page-aligned, for one run after another.
class Workspace {
public:
    void *zeroed(uint64_t size);

private:
    struct Free {
        void operator()(void *memory) const { std::free(memory); }
    };
    std::unique_ptr<void, Free> memory;
};

// The bytes as they are coded: relative operands made absolute.
std::vector<uint8_t> filter(const std::vector<uint8_t> &image, const Layout &layout);

struct Encoded {
    std::vector<uint8_t> payload;
    std::vector<float> bits; // what each byte of the image costs
};
Encoded encode(const std::vector<uint8_t> &image, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace);

// The payload's size in bytes, without making it. Gives up at `enough`, and returns that then.
double measure(const std::vector<uint8_t> &filtered, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace, double enough = 1e30);

// Decodes with the C++ model. Never reads behind the payload: what is missing reads as zeros.
std::vector<uint8_t> decode(const uint8_t *payload, size_t payloadSize, const Layout &layout,
                            const ModelParameters &parameters, Workspace &workspace);

} // namespace pack
