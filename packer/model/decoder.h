// The decoder, which defines the format. The encoder runs the same codeImage() with another coder.
#pragma once

#include "packer/model/model.h"

namespace pack {

// The bytes of a program: `size` in all. The codeSize bytes from codeBegin on are code, the rest is data.
struct Layout {
    uint32_t size, codeBegin, codeSize;
};

// Returns the size in bytes of the slots and the coded bytes, which follow the Model in memory.
template <class Tracker = X86Tracker>
uint64_t memoryAfterModel(const ModelParameters &parameters, uint32_t size) {
    return (sizeof(Slot) << parameters.slotBits) +
           sizeof(typename Tracker::CodedByte) * (kPast + (uint64_t)size + kFuture);
}
template <class Tracker = X86Tracker> uint64_t modelMemory(const ModelParameters &parameters, uint32_t size) {
    return sizeof(Model) + memoryAfterModel<Tracker>(parameters, size);
}

// A binary range decoder, as in LZMA: `code` is a position within `range`, which stays at 2^24 or above.
constexpr uint32_t kRangeBits = 24;
struct Decoder {
    const uint8_t *in;
    uint32_t range = 1, code = 0; // the first call fetches three bytes

    // Returns the next bit. It is a one with the probability share / 2^kShareBits.
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

// Codes all bytes with `coder` and writes them to `image`. An operand that is relative to the next
// instruction is coded as an offset from the start of the image, high byte first. So all operands with the
// same target have the same bytes. `memory`: modelMemory() bytes of zeros, aligned to 64.
template <class Tracker = X86Tracker, class Coder>
void codeImage(Coder &coder, const Layout &layout, const ModelParameters &parameters, void *memory,
               uint8_t *image) {
    Model &m = *(Model *)memory;
    Slot *slots = (Slot *)(&m + 1);
    Tracker tracker = {};
    tracker.coded = (typename Tracker::CodedByte *)(slots + (1u << parameters.slotBits)) + kPast;
    tracker.size = layout.size;
    tracker.prepare(m.opcodes);
    float *weights = (float *)m.finalWeights; // the other weights follow in memory
    uint32_t all = (sizeof m.finalWeights + sizeof m.weights) / sizeof(float);
    for (uint32_t i = 0; i < all; ++i) weights[i] = kFirstWeight;

    for (uint32_t i = 0; i < layout.size; ++i) {
        tracker.begin(i);
        uint32_t data = i - layout.codeBegin >= layout.codeSize;
        beginByte(m, parameters, tracker.fields, data);
        uint32_t bits = 1;
        do {
            uint32_t bit = coder.bit(predict(m, parameters, slots, bits, tracker.odds(bits)));
            learn(m, parameters, bit);
            bits = bits * 2 + bit;
        } while (bits < 256);
        uint8_t byte = (uint8_t)bits;
        endByte(m, parameters, byte);
        tracker.coded[i].byte = image[i] = byte;
        if (data) continue;
        if (uint32_t toNext = tracker.end(i, byte, m.opcodes)) {
            uint32_t value = tracker.fields[tracker.kTarget] - (i + toNext);
            __builtin_memcpy(image + i - 3, &value, 4);
        }
    }
}

} // namespace pack
