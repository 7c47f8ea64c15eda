// The encoder: it runs the decoder's own model.
#pragma once

#include "packer/model/decoder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

namespace pack {

using Bytes = std::vector<uint8_t>;

// Zeroed, page-aligned memory for a run of the model.
class Workspace {
public:
    explicit Workspace(uint64_t size);
    void *zeroed() const;

private:
    std::unique_ptr<void, void (*)(void *)> memory;
};

// Returns the bytes as they are coded: in x86-64, relative operands become absolute.
template <class Tracker = X86Tracker> Bytes filter(const Bytes &image, const Layout &layout);

struct Encoded {
    Bytes payload;
    std::vector<float> bits; // cost of each byte of the image
};

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

// A Decoder that reads at most three bytes beyond `end`, again and again. They must be zeros.
struct CarefulDecoder : Decoder {
    const uint8_t *end;

    uint32_t bit(uint32_t share) {
        in = std::min(in, end);
        return Decoder::bit(share);
    }
};

template <class Tracker, class Coder>
Bytes codeImage(Coder &coder, const Layout &layout, const ModelParameters &parameters) {
    Workspace workspace(modelMemory<Tracker>(parameters, layout.size));
    Bytes image(layout.size);
    codeImage<Tracker>(coder, layout, parameters, workspace.zeroed(), image.data());
    return image;
}

template <class Tracker = X86Tracker>
Encoded encode(const Bytes &image, const Layout &layout, const ModelParameters &parameters) {
    Encoded encoded;
    encoded.bits.resize(image.size());
    Bytes bytes = filter<Tracker>(image, layout);
    Encoder encoder{{bytes.data()}, encoded};
    codeImage<Tracker>(encoder, layout, parameters);
    encoder.finish();
    return encoded;
}

// Returns the payload's size in bytes, without making the payload. Returns `limit` as soon as the size
// exceeds it.
template <class Tracker = X86Tracker>
double measure(const Bytes &filtered, const Layout &layout, const ModelParameters &parameters,
               double limit = 1e30) {
    Meter meter{{filtered.data()}, limit * 8};
    try {
        codeImage<Tracker>(meter, layout, parameters);
    } catch (const LimitExceeded &) {
        return limit;
    }
    return meter.bits / 8;
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
extern template double measure(const Bytes &, const Layout &, const ModelParameters &, double);
extern template Bytes decode(Bytes, const Layout &, const ModelParameters &);

} // namespace pack
