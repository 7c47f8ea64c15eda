// The encoder: it runs the decoder's own model.
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

// Returns the bytes as they are coded: in x86-64, relative operands become absolute.
template <class Tracker = X86Tracker>
std::vector<uint8_t> filter(const std::vector<uint8_t> &image, const Layout &layout);

struct Encoded {
    std::vector<uint8_t> payload;
    std::vector<float> bits; // cost of each byte of the image
};
template <class Tracker = X86Tracker>
Encoded encode(const std::vector<uint8_t> &image, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace);

// Returns the payload's size in bytes, without making the payload. Returns `limit` as soon as the size
// exceeds it.
template <class Tracker = X86Tracker>
double measure(const std::vector<uint8_t> &filtered, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace, double limit = 1e30);

// Decodes with the C++ model. Never reads beyond the payload: missing bytes count as zeros.
template <class Tracker = X86Tracker>
std::vector<uint8_t> decode(const uint8_t *payload, size_t payloadSize, const Layout &layout,
                            const ModelParameters &parameters, Workspace &workspace);

// --- Implementation ---

// Reads the bits of the bytes to encode.
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

// The inverse of Decoder. `low` is the start of the range, without the bytes already written. A carry from
// `low` changes these bytes.
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
    // Writes the highest byte of `low`, and its carry. The very first byte is always zero and is not written.
    void shift() {
        if (low >> 32)
            for (auto byte = to.payload.rbegin(); ++*byte == 0; ++byte) {
            }
        if (started) to.payload.push_back((uint8_t)(low >> 24));
        started = true;
        low = (low & 0xffffff) << 8;
    }
    // Writes two bytes, or more if the range is too small for two, so that the last bits decode correctly
    // whatever bytes follow.
    void finish() {
        for (; range < 1 << 17; range <<= 8) shift();
        low += 0xffff;
        shift();
        shift();
    }
};

struct LimitExceeded {};

// Counts bits and writes nothing.
struct Meter {
    KnownBits known;
    double limit, bits = 0;

    uint32_t bit(uint32_t share) {
        uint32_t bit = known.next();
        bits += cost(bit, share);
        if (bits > limit) throw LimitExceeded{};
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

template <class Tracker>
Encoded encode(const std::vector<uint8_t> &image, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace) {
    Encoded encoded;
    encoded.bits.resize(image.size());
    std::vector<uint8_t> bytes = filter<Tracker>(image, layout), back(image.size());
    Encoder encoder{{bytes.data()}, encoded};
    codeImage<Tracker>(encoder, layout, parameters,
                       workspace.zeroed(modelMemory<Tracker>(parameters, layout.size)), back.data());
    encoder.finish();
    return encoded;
}

template <class Tracker>
double measure(const std::vector<uint8_t> &filtered, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace, double limit) {
    std::vector<uint8_t> back(filtered.size());
    Meter meter{{filtered.data()}, limit * 8};
    try {
        codeImage<Tracker>(meter, layout, parameters,
                           workspace.zeroed(modelMemory<Tracker>(parameters, layout.size)), back.data());
    } catch (const LimitExceeded &) {
        return limit;
    }
    return meter.bits / 8;
}

template <class Tracker>
std::vector<uint8_t> decode(const uint8_t *payload, size_t payloadSize, const Layout &layout,
                            const ModelParameters &parameters, Workspace &workspace) {
    std::vector<uint8_t> image(layout.size);
    CarefulDecoder decoder{payload, payload + payloadSize};
    codeImage<Tracker>(decoder, layout, parameters,
                       workspace.zeroed(modelMemory<Tracker>(parameters, layout.size)), image.data());
    return image;
}

// Compiled only in encoder.cpp: the results of the arithmetic depend on the compiler's options
extern template Encoded encode<X86Tracker>(const std::vector<uint8_t> &, const Layout &,
                                           const ModelParameters &, Workspace &);
extern template double measure<X86Tracker>(const std::vector<uint8_t> &, const Layout &,
                                           const ModelParameters &, Workspace &, double);
extern template std::vector<uint8_t> decode<X86Tracker>(const uint8_t *, size_t, const Layout &,
                                                        const ModelParameters &, Workspace &);

} // namespace pack
