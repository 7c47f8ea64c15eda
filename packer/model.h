// The model: a probability for the next bit, mixed from what followed the same contexts before.
//
// A context is a choice of fields (fields.h), hashed. With the bits of the byte so far it names a slot, which
// gives three inputs, each an adaptive probability: the slot's own; one named by the last bits that followed
// there, shared by all slots of the context; and one named by the byte that followed there last. Eight sets
// of weights, each selected by fields of its own, mix all inputs; a ninth mixes their eight results; a last
// table corrects the outcome by where in an instruction we are. Probabilities are mixed as ln(p / (1 - p)),
// weights follow the error (as in Mahoney's PAQ).
//
// This is the definition; stub.S does the same in fewer bytes, and the packer runs both before it writes
// anything. They must agree to the last bit: single floats, one operation at a time in the order written,
// sums in four lanes. Compile without contraction. The order of contexts and counters matters too, as slots
// may collide.
#pragma once

#include "fields.h"

namespace pack {

constexpr uint32_t kMostContexts = 24, kSets = 8, kRows = 4096;
constexpr uint32_t kLeastSlotBits = 12, kMostSlotBits = 23;

// What the packer chooses for each program.
struct Shape {
    uint32_t contexts; // a multiple of four, 4 .. kMostContexts
    uint32_t slotBits; // 2^slotBits slots of eight bytes
    // Fields seen, a bit each from kByte1 on, by each context and then by the selectors of all sets but the
    // first; of code, and the same for data
    uint16_t masks[2][kMostContexts + kSets - 1];

    uint32_t hashes() const { return contexts + kSets - 1; }
    bool sane() const {
        return contexts >= 4 && contexts <= kMostContexts && contexts % 4 == 0 &&
               slotBits >= kLeastSlotBits && slotBits <= kMostSlotBits;
    }
};

// A probability, signed: -2^23 .. 2^23 for 0 .. 1, over the number of bits it has seen, up to 255: 24 and 8
// bits. Fresh memory is one that has seen nothing.
typedef uint32_t Counter;
constexpr int32_t kCertain = (1 << 23) - 1;

struct Slot {
    Counter counter;
    uint8_t history;  // the last bits seen behind a leading one; the lowest bit flipped
    uint8_t lastByte; // at the slot of a byte's first bit only: the byte that followed here last
    uint16_t check;   // whose slot it is
};

typedef float Float4 __attribute__((vector_size(16)));
constexpr uint32_t kInputs4 = kMostContexts * 3 / 4;
// Logarithms are in units of a float's last bit.
constexpr float kLogUnit = 0.69314718f / (1 << 23);
constexpr float kFirstWeight = 1.0f / 16, kLearning = 1.0f / 160 * kLogUnit,
                kFinalLearning = 1.0f / 1024 * kLogUnit;
constexpr uint32_t kFirstTrust = 20; // bits that a correction starts with

struct Context {
    Slot *slot, *byteSlot; // of this bit, and of this byte's first bit
    Counter *counter[3];
    Counter histories[256], afterLast[256][256];
};

struct Model {
    Float4 inputs[kInputs4], results[kSets / 4];
    Float4 *rows[kSets];
    Counter *correction;
    float mixed;
    uint32_t hashes[kMostContexts + kSets - 1];
    Context contexts[kMostContexts];
    uint8_t opcodes[1024];
    Counter corrections[65536][32];
    Float4 finalWeights[kSets / 4], weights[kSets][kRows][kInputs4];
};

union FloatBits {
    float value;
    int32_t bits;
};

// ln(x), piecewise linear: a float's bits are its logarithm, nearly.
inline int32_t logBits(int32_t x) { return FloatBits{(float)x}.bits; }

// ln(p / (1 - p)) of a counter, and back, by the same kind of curve.
inline float stretch(Counter c) {
    int32_t p = (int32_t)c >> 8;
    return (float)(logBits(kCertain + 2 + p) - logBits(kCertain + 2 - p));
}
inline float squash(float x) {
    FloatBits odds;
    odds.bits = (int32_t)x + 0x3f800000;
    return odds.value / (odds.value + 1);
}

inline float mix(const Float4 *weights, const Float4 *inputs, uint32_t count4) {
    Float4 sums = {};
    while (count4--) sums += weights[count4] * inputs[count4];
    float sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
    constexpr float kMost = 11 / kLogUnit;
    return sum > kMost ? kMost : sum < -kMost ? -kMost : sum;
}

inline void train(Float4 *weights, const Float4 *inputs, uint32_t count4, float by) {
    while (count4--) weights[count4] += inputs[count4] * by;
}

inline void adapt(Counter &c, uint32_t bit) {
    int32_t p = (int32_t)c >> 8;
    uint32_t seen = c & 255;
    p += (int32_t)((float)((bit ? kCertain : ~kCertain) - p) / ((float)(int32_t)seen + 1.1f));
    c = (uint32_t)p << 8 | (seen + (seen < 255));
}

// A new byte begins, in code (0) or data (1).
inline void begin(Model &m, const Shape &shape, const uint32_t *fields, uint32_t type) {
    for (uint32_t i = 0; i < shape.hashes(); ++i) {
        uint32_t hash = mixIn(shape.hashes() - i + type, fields[kWhere]), mask = shape.masks[type][i];
        for (uint32_t j = kByte1; mask; mask >>= 1, ++j)
            if (mask & 1) hash = mixIn(hash, fields[j]);
        m.hashes[i] = hash;
    }
}

// The probability of a one, of 2^20; 1 .. 2^20 - 1. `bits`: the byte so far behind a leading one.
inline uint32_t predict(Model &m, const Shape &shape, Slot *slots, uint32_t bits) {
    // Find the counters
    for (uint32_t i = 0; i < shape.contexts; ++i) {
        Context &c = m.contexts[i];
        uint32_t hash = mixIn(m.hashes[i], bits);
        uint16_t check = (uint16_t)hash;
        uint32_t place = hash >> (32 - shape.slotBits);
        Slot *s = slots + place;
        if (s->check != check) {
            Slot *other = slots + (place ^ 1);
            if (other->check == check)
                s = other;
            else {
                if (other->history < s->history) s = other;
                *s = Slot{0, 0, 0, check};
            }
        }
        c.slot = s;
        if (bits == 1) c.byteSlot = s;
        c.counter[0] = &s->counter;
        c.counter[1] = &c.histories[s->history];
        c.counter[2] = &c.afterLast[c.byteSlot->lastByte][bits];
    }
    float *x = (float *)m.inputs, *results = (float *)m.results;
    for (uint32_t i = 0; i < shape.contexts; ++i)
        for (int k = 0; k < 3; ++k) *x++ = stretch(*m.contexts[i].counter[k]);

    // Mix. The last set's result lies first
    for (uint32_t i = 0; i < kSets; ++i) {
        m.rows[i] = m.weights[i][i ? m.hashes[shape.contexts + i - 1] >> 20 : bits];
        results[kSets - 1 - i] = mix(m.rows[i], m.inputs, shape.contexts * 3 / 4);
    }
    float sum = mix(m.finalWeights, m.results, kSets / 4);
    m.mixed = squash(sum);

    // Correct
    m.correction =
        m.corrections[mixIn(m.hashes[shape.contexts], bits) >> 16] + (int32_t)(sum * (1.25f * kLogUnit) + 16);
    int32_t p = (int32_t)(m.mixed * (1 << 24));
    if (!*m.correction) *m.correction = (uint32_t)(p - (1 << 23)) << 8 | kFirstTrust;
    return (uint32_t)(((int32_t)*m.correction >> 8) + p + (1 << 23)) >> 5 | 1;
}

inline void learn(Model &m, const Shape &shape, uint32_t bit) {
    float y = (float)(int32_t)bit;
    const float *results = (const float *)m.results;
    for (uint32_t i = 0; i < kSets; ++i)
        train(m.rows[i], m.inputs, shape.contexts * 3 / 4, (y - squash(results[kSets - 1 - i])) * kLearning);
    train(m.finalWeights, m.results, kSets / 4, (y - m.mixed) * kFinalLearning);
    for (uint32_t i = 0; i < shape.contexts; ++i)
        for (Counter *c : m.contexts[i].counter) adapt(*c, bit);
    adapt(*m.correction, bit);
    for (uint32_t i = 0; i < shape.contexts; ++i) {
        uint8_t &history = m.contexts[i].slot->history;
        uint32_t h = history ^ 1u;
        if (h & 128) h = (h & 63) | 64;
        history = (uint8_t)((h * 2 + bit) ^ 1);
    }
}

// The byte was this.
inline void end(Model &m, const Shape &shape, uint8_t byte) {
    for (uint32_t i = 0; i < shape.contexts; ++i) m.contexts[i].byteSlot->lastByte = byte;
}

} // namespace pack
