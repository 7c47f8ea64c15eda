// Decoding: the format's definition. The stub and the packer's own check run this very code.
#pragma once

#include "model.h"

namespace pack {

// Binary arithmetic coding over the 32-bit interval [low, high]; leading bytes leave when they agree (as in
// lpaq). The model must be zeroed.
__attribute__((always_inline)) static inline void decode(const uint8_t *in, uint8_t *out, uint32_t size,
                                                         Model &model) {
    uint32_t low = 0, high = 0xffffffffu, code = 0;
    for (int i = 0; i < 4; ++i) code = code << 8 | *in++;
    uint64_t before = 0;
    for (uint8_t *end = out + size; out != end; ++out) {
        uint32_t bits = 1;
        while (bits < 256) {
            Prediction q;
            predict(model, before, bits, q);
            uint32_t middle = low + (uint32_t)((uint64_t)(high - low) * q.share >> 16);
            int bit = code <= middle;
            if (bit)
                high = middle;
            else
                low = middle + 1;
            learn(q, bit);
            bits = bits * 2 + (uint32_t)bit;
            while ((low ^ high) < 1u << 24) {
                low <<= 8;
                high = high << 8 | 255;
                code = code << 8 | *in++;
            }
        }
        *out = (uint8_t)bits;
        before = before << 8 | (uint8_t)bits;
    }
}

} // namespace pack
