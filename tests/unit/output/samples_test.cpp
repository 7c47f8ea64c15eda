// Tests the music's last step: floats are rounded to 16-bit samples, with dither.
#include "output/samples.h"

using namespace odraz;

constexpr int kCount = 2 * kSoundBlock;

static std::vector<int16_t> samplesOf(float value, int number) {
    std::vector<float> block(kCount, value);
    std::vector<int16_t> samples(kCount);
    quantize(block.data(), number, samples.data());
    return samples;
}

TEST(Samples, AreWithinOneAndAHalfOfTheirValue) {
    for (float value : {0.f, 1e-9f, 0.25f, -0.25f, 0.5f, -0.5f, 0.9999f, -0.9999f})
        for (int16_t sample : samplesOf(value, 3))
            ASSERT_LE(std::fabs(sample - value * 32767.f), 1.5f) << value;
}

// The error is the dither, a difference of two uniform numbers with a variance of 1/6, plus the rounding
// error with 1/12. It has no bias.
TEST(Samples, AreDitheredByATriangle) {
    constexpr int kBlocks = 400;
    for (float between : {0.f, 0.25f, 0.5f, 0.8f}) { // position between two 16-bit values
        double sum = 0, squares = 0;
        for (int number = 0; number < kBlocks; ++number)
            for (int16_t sample : samplesOf((1000 + between) / 32767, number)) {
                double off = sample - (1000 + (double)between);
                sum += off, squares += off * off;
            }
        double n = (double)kBlocks * kCount, mean = sum / n;
        EXPECT_NEAR(mean, 0, 5 * std::sqrt(0.25 / n)) << between;
        EXPECT_NEAR(squares / n, 1 / 6. + 1 / 12., 0.005)
            << between; // the same variance everywhere: noise, not distortion
    }
}

// A device and a file get the same samples, even if blocks are made again or in another order.
TEST(Samples, DependOnTheBlockAlone) {
    std::vector<int16_t> first = samplesOf(0.3f, 7);
    EXPECT_NE(samplesOf(0.3f, 8), first);
    EXPECT_EQ(samplesOf(0.3f, 7), first);
}

TEST(Samples, EndAtTheirLimits) {
    for (int number = 0; number < 50; ++number) {
        for (int16_t sample : samplesOf(1 - 1.5f / 32767, number)) ASSERT_GT(sample, 32000);
        for (int16_t sample : samplesOf(-1, number)) ASSERT_LT(sample, -32000);
    }
}
