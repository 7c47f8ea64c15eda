// Decoding, which defines the format. The encoder runs the same code with another coder, which has the
// bits and writes them.
#pragma once

#include "packer/model/model.h"

namespace pack {

// What is decoded: a program's bytes, of which one stretch is code.
struct Layout {
    uint32_t size, codeBegin, codeSize;
};

template <class Around = Surroundings>
uint64_t memoryBehindModel(const ModelParameters &parameters, uint32_t size) {
    return (sizeof(Slot) << parameters.slotBits) +
           sizeof(typename Around::Place) * (kPast + (uint64_t)size + kFuture);
}
template <class Around = Surroundings>
uint64_t modelMemory(const ModelParameters &parameters, uint32_t size) {
    return sizeof(Model) + memoryBehindModel<Around>(parameters, size);
}

// A binary range decoder, as in LZMA: `code` is a position within `range`, which is kept at 2^24 or above.
constexpr uint32_t kRangeBits = 24;
struct Decoder {
    const uint8_t *in;
    uint32_t range = 1, code = 0; // the first call fetches three bytes

    // The next bit, whose probability of being a one is share / 2^kShareBits.
    uint32_t bit(uint32_t share) {
        for (; range < 1u << kRangeBits; range <<= 8) code = code << 8 | *in++;
        uint32_t ones = (uint32_t)((uint64_t)range * share >> kShareBits);
        if (code < ones) {
            range = ones;
            return 1;
        }
        range -= ones;
        code -= ones;
        return 0;
    }
};

// Writes `image` from the coder's bits. Operands that name addresses relative to the next instruction are
// coded as offsets from the start of the image, high byte first, so that one target looks the same wherever
// it is named. `memory`: modelMemory() bytes of zeros, aligned to 64.
template <class Around = Surroundings, class Coder>
void run(Coder &coder, const Layout &layout, const ModelParameters &parameters, void *memory,
         uint8_t *image) {
    Model &m = *(Model *)memory;
    Slot *slots = (Slot *)(&m + 1);
    Around s = {};
    s.places = (typename Around::Place *)(slots + (1u << parameters.slotBits)) + kPast;
    s.size = layout.size;
    s.prepare(m.opcodes);
    float *weights = (float *)m.finalWeights; // the other weights follow in memory
    uint32_t all = (sizeof m.finalWeights + sizeof m.weights) / sizeof(float);
    for (uint32_t i = 0; i < all; ++i) weights[i] = kFirstWeight;

    for (uint32_t i = 0; i < layout.size; ++i) {
        s.begin(i);
        uint32_t data = i - layout.codeBegin >= layout.codeSize;
        begin(m, parameters, s.fields, data);
        uint32_t bits = 1;
        do {
            uint32_t bit = coder.bit(predict(m, parameters, slots, bits, s.odds(bits)));
            learn(m, parameters, bit);
            bits = bits * 2 + bit;
        } while (bits < 256);
        uint8_t byte = (uint8_t)bits;
        end(m, parameters, byte);
        s.places[i].byte = image[i] = byte;
        if (data) continue;
        if (uint32_t behind = s.end(i, byte, m.opcodes)) {
            uint32_t value = s.fields[s.kTarget] - (i + behind);
            __builtin_memcpy(image + i - 3, &value, 4);
        }
    }
}

} // namespace pack
