// Decoding, which defines the format. The encoder runs the same code with another coder, which knows the bits
// and writes them.
#pragma once

#include "model.h"

namespace pack {

// What is decoded: a program's bytes, of which one stretch is code.
struct Layout {
    uint32_t size, codeBegin, codeSize;
};

constexpr uint32_t kPast = 8; // zeros that stand for the bytes before the first one
static_assert(kPast >= kByte5);

inline uint64_t memoryBehindModel(const ModelParameters &parameters, uint32_t size) {
    return (sizeof(Slot) << parameters.slotBits) + kPast + size;
}
inline uint64_t modelMemory(const ModelParameters &parameters, uint32_t size) {
    return sizeof(Model) + memoryBehindModel(parameters, size);
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
// it is named. `memory`: modelMemory() bytes of zeros, aligned to 16.
template <class Coder>
void run(Coder &coder, const Layout &layout, const ModelParameters &parameters, void *memory,
         uint8_t *image) {
    Model &m = *(Model *)memory;
    Slot *slots = (Slot *)(&m + 1);
    uint8_t *now = (uint8_t *)(slots + (1u << parameters.slotBits)) + kPast; // bytes as they were coded
    uint32_t fields[kFields] = {};
    Parser parser = {};
    expandOpcodes(m.opcodes);
    float *weights = (float *)m.finalWeights; // the other weights follow in memory
    for (uint32_t i = 0; i < kPhases * kSets + kSets * kRows * kMostInputs; ++i) weights[i] = kFirstWeight;

    for (uint32_t i = 0; i < layout.size; ++i) {
        for (uint32_t k = kByte1; k <= kByte5; ++k) fields[k] = *(now - k);
        fields[kWhere] = parser.left << kPhaseBits | parser.phase;
        fields[kColumn] = i % kColumns;
        uint32_t data = i - layout.codeBegin >= layout.codeSize;
        begin(m, parameters, fields, data);
        uint32_t bits = 1;
        do {
            uint32_t bit = coder.bit(predict(m, parameters, slots, bits));
            learn(m, parameters, bit);
            bits = bits * 2 + bit;
        } while (bits < 256);
        uint8_t byte = (uint8_t)bits;
        end(m, parameters, byte);
        *now++ = image[i] = byte;
        if (data) continue;
        if (uint32_t behind = parser.step(fields, byte, m.opcodes)) {
            uint32_t value;
            __builtin_memcpy(&value, image + i - 3, 4);
            fields[kTarget] = value = __builtin_bswap32(value);
            value -= i + behind;
            __builtin_memcpy(image + i - 3, &value, 4);
        }
    }
}

} // namespace pack
