// What deflate() packs, stb's decoder unpacks.
#include "packer/report/deflate.h"

#include <gtest/gtest.h>
#include <random>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>

using namespace pack;
using Bytes = std::vector<uint8_t>;

namespace {

// The size that it was packed to.
size_t packs(const Bytes &bytes) {
    Bytes packed = deflate(bytes), unpacked(bytes.size() + 1);
    int size = stbi_zlib_decode_buffer((char *)unpacked.data(), (int)unpacked.size(),
                                       (const char *)packed.data(), (int)packed.size());
    EXPECT_EQ(size, (int)bytes.size());
    unpacked.resize(bytes.size());
    EXPECT_EQ(unpacked, bytes);
    return packed.size();
}

} // namespace

TEST(Deflate, PacksAnything) {
    std::mt19937 random(1);
    packs({});
    packs({7});
    packs({7, 7});
    for (unsigned letters : {1u, 2u, 20u, 256u})
        for (size_t size : {3u, 257u, 258u, 259u, 5000u, 200000u}) {
            Bytes bytes(size);
            for (uint8_t &b : bytes) b = (uint8_t)(random() % letters);
            packs(bytes);
        }
}

TEST(Deflate, FindsWhatRepeats) {
    std::mt19937 random(2);
    Bytes bytes(32768);
    for (uint8_t &b : bytes) b = (uint8_t)random();
    Bytes twice(2 * bytes.size()); // as far back as can be
    for (size_t i = 0; i < twice.size(); ++i) twice[i] = bytes[i % bytes.size()];
    EXPECT_LT(packs(twice), bytes.size() + 2000);
    EXPECT_LT(packs(Bytes(1 << 20)), 3000u);
}

TEST(Deflate, LimitsTheLengthsOfCodes) {
    // Frequencies that grow like Fibonacci's numbers make the deepest tree
    Bytes bytes;
    size_t a = 1, b = 1;
    for (uint8_t letter = 0; letter < 24; ++letter) {
        for (size_t i = 0; i < a; ++i) bytes.push_back((uint8_t)(letter * 11 + 3));
        std::swap(a, b);
        b += a;
    }
    std::shuffle(bytes.begin(), bytes.end(), std::mt19937(3));
    packs(bytes);
}

TEST(Deflate, HasItsChecksum) {
    Bytes packed = deflate({'W', 'i', 'k', 'i', 'p', 'e', 'd', 'i', 'a'});
    EXPECT_EQ(Bytes(packed.end() - 4, packed.end()), (Bytes{0x11, 0xe6, 0x03, 0x98}));
}

TEST(Base64, IsFilledUp) {
    EXPECT_EQ(base64({}), "");
    EXPECT_EQ(base64({'M'}), "TQ==");
    EXPECT_EQ(base64({'M', 'a'}), "TWE=");
    EXPECT_EQ(base64({'M', 'a', 'n', 0xff, 0xfe, 0xfd}), "TWFu//79");
}
