// The model: a probability for the next bit, from eight contexts of the bytes before it, mixed.
//
// Every context names, hashed with the bits of the byte so far, a slot with two memories: an adaptive
// probability, and the last few bits that followed there, which name a second adaptive probability, shared by
// all slots of that context with the same history. Probabilities enter the mixer as x = u / sqrt(1 - u^2), u
// = 2p - 1, and leave it the inverse way: close enough to the logistic function, and without tables. Weights
// follow the error.
//
// Encoder and stub must agree to the last bit: single floats, one operation at a time in the order written,
// square root and division as IEEE 754 rounds them. Compile without contraction.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace pack {

constexpr int kContexts = 8, kInputs = 2 * kContexts, kSlotBits = 22;

// Which of the last eight bytes a context sees, the last one in the lowest bit.
constexpr uint8_t kMasks[kContexts] = {0x00, 0x01, 0x03, 0x07, 0x0a, 0x05, 0x06, 0x1c};

// A counter is a probability of a one over the number of bits seen: 22 bits, signed, 2^21 units from 0 to
// certainty, and 10 bits.
struct Model {
    uint32_t direct[1 << kSlotBits];
    uint8_t history[1 << kSlotBits]; // the last bits seen behind a leading one; the lowest bit flipped
    uint32_t mapped[kContexts][256];
    float weights[256][kInputs]; // by the bits of the byte so far, less kFirstWeight
};                               // all zero at first

constexpr float kFirstWeight = 0.1f, kRate = 0.01f / 65536;
constexpr int32_t kCertain = (1 << 21) - 1, kMostSeen = 60;

static inline float squareRoot(float x) {
    __asm__("sqrtss %0, %0" : "+x"(x));
    return x;
}

// One bit's prediction and what is needed to learn from it.
struct Prediction {
    uint32_t *counter[kInputs];
    uint8_t *history[kContexts];
    float input[kInputs];
    float *weights;
    uint32_t share; // of a one, of 65536; 1 .. 65535
};

// `before`: the last eight bytes, the latest lowest; `bits`: the byte so far behind a leading one.
__attribute__((always_inline)) static inline void predict(Model &m, uint64_t before, uint32_t bits,
                                                          Prediction &q) {
    for (uint32_t i = 0; i < kContexts; ++i) {
        // Hash what the context sees, and the bits
        uint32_t hash = i;
        uint64_t bytes = before;
        for (uint32_t mask = kMasks[i] | 0x100; mask; mask >>= 1, bytes >>= 8) {
            if (mask & 1) hash = (hash + (mask == 1 ? bits : (uint8_t)bytes) + 1) * 0x2c9277b5u;
            hash ^= hash >> 15;
        }
        hash &= (1 << kSlotBits) - 1;
        q.history[i] = &m.history[hash];
        q.counter[i] = &m.direct[hash];
        q.counter[i + kContexts] = &m.mapped[i][m.history[hash]];
    }
    q.weights = m.weights[bits];
    float sum = 0;
    for (int i = 0; i < kInputs; ++i) {
        float p = (float)((int32_t)*q.counter[i] >> 10);
        q.input[i] = p / squareRoot(1.01f * 4398046511104.f - p * p);
        sum += q.input[i] * (q.weights[i] + kFirstWeight);
    }
    q.share = 32768 + (uint32_t)(int32_t)(sum / squareRoot(1 + sum * sum) * 32767);
}

__attribute__((always_inline)) static inline void learn(const Prediction &q, int bit) {
    float error = (float)((bit << 16) - (int32_t)q.share) * kRate;
    for (int i = 0; i < kInputs; ++i) {
        q.weights[i] += error * q.input[i];
        // Towards the bit, by one over the number seen
        int32_t p = (int32_t)*q.counter[i] >> 10, seen = *q.counter[i] & 1023;
        p += ((bit ? kCertain : -kCertain) - p) * 2 / (2 * seen + 3);
        *q.counter[i] = (uint32_t)p << 10 | (uint32_t)(seen + (seen < kMostSeen));
    }
    for (int i = 0; i < kContexts; ++i) {
        uint32_t h = *q.history[i] ^ 1u;
        if (h & 128) h = (h & 63) | 64;
        *q.history[i] = (uint8_t)((h * 2 + (uint32_t)bit) ^ 1);
    }
}

} // namespace pack
