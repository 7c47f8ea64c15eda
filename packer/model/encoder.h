// The encoder: it runs the decoder's own model.
#pragma once

#include "packer/model/decoder.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace pack {

using Bytes = std::vector<uint8_t>;

// Pages of zeros, for a run of the model.
struct Unmap {
    size_t size;
    void operator()(void *pages) const;
};
std::unique_ptr<void, Unmap> zeroedPages(size_t size);

// Returns the bytes as they are coded: in x86-64, relative operands become absolute.
template <class Tracker = X86Tracker> Bytes filter(const Bytes &image, const Layout &layout);

struct Encoded {
    Bytes payload;
    std::vector<float> bits; // cost of each byte of the image

    double size() const { return std::accumulate(bits.begin(), bits.end(), 0.0) / 8; } // in bytes
};

inline double cost(uint32_t bit, uint32_t share) {
    constexpr double kAll = 1 << kShareBits;
    return -std::log2((bit ? share : kAll - share) / kAll);
}

// The inverse of Decoder. `low` is the start of the range; a carry changes the bytes already written.
struct Encoder {
    const Bytes &bytes;
    Encoded &to;
    uint32_t position = 0; // in bits
    uint64_t low = 0;
    uint32_t range = 1 << kRangeBits;
    bool started = false;

    uint32_t bit(uint32_t share) {
        for (; range < 1u << kRangeBits; range <<= 8) shift();
        uint32_t at = position >> 3, bit = bytes[at] >> (~position & 7) & 1;
        ++position;
        to.bits[at] += (float)cost(bit, share);
        uint32_t ones = (uint32_t)((uint64_t)range * share >> kShareBits);
        if (bit)
            range = ones;
        else {
            low += ones;
            range -= ones;
        }
        return bit;
    }
    // Writes the highest byte of `low`, and its carry. The very first byte is always zero and is not written.
    void shift() {
        if (low >> 32)
            for (auto byte = to.payload.rbegin(); ++*byte == 0; ++byte) {
            }
        if (started) to.payload.push_back((uint8_t)(low >> 24));
        started = true;
        low = (low & 0xffffff) << 8;
    }
    // Writes two bytes, or more if the range is too small: the last bits decode whatever bytes follow.
    void finish() {
        for (; range < 1 << 17; range <<= 8) shift();
        low += 0xffff;
        shift();
        shift();
    }
};

// A Decoder that does not read beyond the three bytes at `end`, which must be zeros.
struct CarefulDecoder : Decoder {
    const uint8_t *end;

    uint32_t bit(uint32_t share) {
        in = std::min(in, end);
        return Decoder::bit(share);
    }
};

template <class Tracker, class Coder>
Bytes codeImage(Coder &coder, const Layout &layout, const ModelParameters &parameters) {
    auto memory = zeroedPages(modelMemory<Tracker>(parameters, layout.size));
    Bytes image(layout.size);
    codeImage<Tracker>(coder, layout, parameters, memory.get(), image.data());
    return image;
}

template <class Tracker = X86Tracker>
Encoded encode(const Bytes &image, const Layout &layout, const ModelParameters &parameters) {
    Encoded encoded;
    encoded.bits.resize(image.size());
    Bytes bytes = filter<Tracker>(image, layout);
    Encoder encoder{bytes, encoded};
    codeImage<Tracker>(encoder, layout, parameters);
    encoder.finish();
    return encoded;
}

// Decodes with the C++ model. Never reads beyond the payload: missing bytes count as zeros.
template <class Tracker = X86Tracker>
Bytes decode(Bytes payload, const Layout &layout, const ModelParameters &parameters) {
    payload.resize(payload.size() + 3);
    CarefulDecoder decoder{{payload.data()}, &payload.end()[-3]};
    return codeImage<Tracker>(decoder, layout, parameters);
}

// Compiled only in encoder.cpp: the results of the arithmetic depend on the compiler's options
extern template Encoded encode(const Bytes &, const Layout &, const ModelParameters &);
extern template Bytes decode(Bytes, const Layout &, const ModelParameters &);

} // namespace pack
