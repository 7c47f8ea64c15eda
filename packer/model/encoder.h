// Encoding a program's bytes, with the decoder's own model.
#pragma once

#include "packer/model/decoder.h"

#include <cstdlib>
#include <memory>
#include <vector>

namespace pack {

// Zeroed, page-aligned memory for the model, for one run at a time.
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
    std::vector<float> bits; // cost of each byte of the image
};
Encoded encode(const std::vector<uint8_t> &image, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace);

// The payload's size in bytes, without making the payload. Stops when the size exceeds `enough`, and returns
// `enough` then.
double measure(const std::vector<uint8_t> &filtered, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace, double enough = 1e30);

// Decodes with the C++ model. Never reads beyond the payload: missing bytes count as zeros.
std::vector<uint8_t> decode(const uint8_t *payload, size_t payloadSize, const Layout &layout,
                            const ModelParameters &parameters, Workspace &workspace);

} // namespace pack
