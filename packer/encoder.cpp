#include "encoder.h"

#include "decoder.h"

#include <memory>

namespace pack {

std::vector<uint8_t> encode(const std::vector<uint8_t> &bytes) {
    auto model = std::make_unique<Model>();
    std::vector<uint8_t> out;
    uint32_t low = 0, high = 0xffffffffu;
    uint64_t before = 0;
    for (uint8_t byte : bytes) {
        uint32_t bits = 1;
        for (int i = 7; i >= 0; --i) {
            Prediction q;
            predict(*model, before, bits, q);
            uint32_t middle = low + (uint32_t)((uint64_t)(high - low) * q.share >> 16);
            int bit = byte >> i & 1;
            if (bit)
                high = middle;
            else
                low = middle + 1;
            learn(q, bit);
            bits = bits * 2 + (uint32_t)bit;
            while ((low ^ high) < 1u << 24) {
                out.push_back((uint8_t)(high >> 24));
                low <<= 8;
                high = high << 8 | 255;
            }
        }
        before = before << 8 | byte;
    }
    // Any number in the interval ends it; the decoder reads four bytes ahead
    for (int shift = 24; shift >= 0; shift -= 8) out.push_back((uint8_t)(high >> shift));
    return out;
}

std::vector<uint8_t> decodeAgain(const std::vector<uint8_t> &coded, size_t size) {
    auto model = std::make_unique<Model>();
    std::vector<uint8_t> out(size), padded = coded;
    padded.resize(coded.size() + size + 8); // damaged input may ask for more than there is
    decode(padded.data(), out.data(), (uint32_t)size, *model);
    return out;
}

} // namespace pack
