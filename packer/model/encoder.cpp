#include "packer/model/encoder.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace pack {

namespace {

// The bits of the bytes to encode, one by one.
struct Known {
    const uint8_t *bytes;
    uint32_t position = 0;

    uint32_t next() {
        uint32_t bit = bytes[position >> 3] >> (~position & 7) & 1;
        ++position;
        return bit;
    }
};

double cost(uint32_t bit, uint32_t share) {
    constexpr double kAll = 1 << kShareBits;
    return -std::log2((bit ? share : kAll - share) / kAll);
}

// The inverse of Decoder. `low` is where the range starts, without the bytes already written; it may carry
// into these.
struct Encoder {
    Known known;
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
    Known known;
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

} // namespace

void *Workspace::zeroed(uint64_t size) {
    constexpr uint64_t kPageSize = 4096;
    // Fresh pages instead of clearing old ones, since a short run touches few
    memory.reset();
    memory.reset(std::calloc(size + kPageSize, 1));
    if (!memory) throw std::bad_alloc();
    return (void *)(((uintptr_t)memory.get() + kPageSize - 1) & ~(kPageSize - 1));
}

Encoded encode(const std::vector<uint8_t> &image, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace) {
    Encoded encoded;
    encoded.bits.resize(image.size());
    std::vector<uint8_t> bytes = filter(image, layout), back(image.size());
    Encoder encoder{{bytes.data()}, encoded};
    run(encoder, layout, parameters, workspace.zeroed(modelMemory(parameters, layout.size)), back.data());
    encoder.finish();
    return encoded;
}

double measure(const std::vector<uint8_t> &filtered, const Layout &layout, const ModelParameters &parameters,
               Workspace &workspace, double enough) {
    std::vector<uint8_t> back(filtered.size());
    Meter meter{{filtered.data()}, enough * 8};
    try {
        run(meter, layout, parameters, workspace.zeroed(modelMemory(parameters, layout.size)), back.data());
    } catch (const TooMuch &) {
        return enough;
    }
    return meter.bits / 8;
}

std::vector<uint8_t> decode(const uint8_t *payload, size_t payloadSize, const Layout &layout,
                            const ModelParameters &parameters, Workspace &workspace) {
    std::vector<uint8_t> image(layout.size);
    CarefulDecoder decoder{payload, payload + payloadSize};
    run(decoder, layout, parameters, workspace.zeroed(modelMemory(parameters, layout.size)), image.data());
    return image;
}

} // namespace pack
