// Encoding a program's bytes, with the decoder's own model.
#pragma once

#include "packer/model/decoder.h"

#include <algorithm>
#include <cmath>
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

// The bytes as they are coded: in x86-64, relative operands made absolute.
template <class Around = Surroundings>
std::vector<uint8_t> filter(const std::vector<uint8_t> &image, const Layout &layout);

struct Encoded {
    std::vector<uint8_t> payload;
    std::vector<float> bits; // cost of each byte of the image
};
template <class Around = Surroundings>
Encoded encode(const std::vector<uint8_t> &image, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace);

// The payload's size in bytes, without making the payload. Stops when the size exceeds `enough`, and returns
// `enough` then.
template <class Around = Surroundings>
double measure(const std::vector<uint8_t> &filtered, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace, double enough = 1e30);

// Decodes with the C++ model. Never reads beyond the payload: missing bytes count as zeros.
template <class Around = Surroundings>
std::vector<uint8_t> decode(const uint8_t *payload, size_t payloadSize, const Layout &layout,
                            const ModelParameters &parameters, Workspace &workspace);

// --- What does it ---

// The bits of the bytes to encode, one by one.
struct KnownBits {
    const uint8_t *bytes;
    uint32_t position = 0;

    uint32_t next() {
        uint32_t bit = bytes[position >> 3] >> (~position & 7) & 1;
        ++position;
        return bit;
    }
};

inline double cost(uint32_t bit, uint32_t share) {
    constexpr double kAll = 1 << kShareBits;
    return -std::log2((bit ? share : kAll - share) / kAll);
}

// The inverse of Decoder. `low` is where the range starts, without the bytes already written; it may carry
// into these.
struct Encoder {
    KnownBits known;
    Encoded &to;
    uint64_t low = 0;
    uint32_t range = 1 << kRangeBits;
    bool started = false;

    uint32_t bit(uint32_t share) {
        for (; range < 1u << kRangeBits; range <<= 8) shift();
        uint32_t at = known.position >> 3, bit = known.next();
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
    // Writes the highest of low's four bytes, and its carry. The very first byte is always zero and is not
    // written.
    void shift() {
        if (low >> 32)
            for (auto byte = to.payload.rbegin(); ++*byte == 0; ++byte) {
            }
        if (started) to.payload.push_back((uint8_t)(low >> 24));
        started = true;
        low = (low & 0xffffff) << 8;
    }
    // Writes two bytes such that any bytes after them decode within the range; more bytes if the range is too
    // small for two
    void finish() {
        for (; range < 1 << 17; range <<= 8) shift();
        low += 0xffff;
        shift();
        shift();
    }
};

struct TooMuch {};

struct Meter {
    KnownBits known;
    double enough, bits = 0;

    uint32_t bit(uint32_t share) {
        uint32_t bit = known.next();
        bits += cost(bit, share);
        if (bits > enough) throw TooMuch{};
        return bit;
    }
};

// A Decoder that does not read beyond the payload.
struct CarefulDecoder {
    const uint8_t *in, *end;
    Decoder inner{nullptr};

    uint32_t bit(uint32_t share) {
        uint8_t next[3] = {};
        size_t count = std::min<size_t>(3, (size_t)(end - in));
        std::copy_n(in, count, next);
        inner.in = next;
        uint32_t bit = inner.bit(share);
        in += std::min(count, (size_t)(inner.in - next));
        return bit;
    }
};

template <class Around>
Encoded encode(const std::vector<uint8_t> &image, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace) {
    Encoded encoded;
    encoded.bits.resize(image.size());
    std::vector<uint8_t> bytes = filter<Around>(image, layout), back(image.size());
    Encoder encoder{{bytes.data()}, encoded};
    run<Around>(encoder, layout, parameters, workspace.zeroed(modelMemory<Around>(parameters, layout.size)),
                back.data());
    encoder.finish();
    return encoded;
}

template <class Around>
double measure(const std::vector<uint8_t> &filtered, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace, double enough) {
    std::vector<uint8_t> back(filtered.size());
    Meter meter{{filtered.data()}, enough * 8};
    try {
        run<Around>(meter, layout, parameters, workspace.zeroed(modelMemory<Around>(parameters, layout.size)),
                    back.data());
    } catch (const TooMuch &) {
        return enough;
    }
    return meter.bits / 8;
}

template <class Around>
std::vector<uint8_t> decode(const uint8_t *payload, size_t payloadSize, const Layout &layout,
                            const ModelParameters &parameters, Workspace &workspace) {
    std::vector<uint8_t> image(layout.size);
    CarefulDecoder decoder{payload, payload + payloadSize};
    run<Around>(decoder, layout, parameters, workspace.zeroed(modelMemory<Around>(parameters, layout.size)),
                image.data());
    return image;
}

// Those for x86-64 are in encoder.cpp, since arithmetic depends on how it is compiled
extern template Encoded encode<Surroundings>(const std::vector<uint8_t> &, const Layout &,
                                             const ModelParameters &, Workspace &);
extern template double measure<Surroundings>(const std::vector<uint8_t> &, const Layout &,
                                             const ModelParameters &, Workspace &, double);
extern template std::vector<uint8_t> decode<Surroundings>(const uint8_t *, size_t, const Layout &,
                                                          const ModelParameters &, Workspace &);

} // namespace pack
