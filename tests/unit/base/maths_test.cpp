// Tests properties of the maths functions. maths_exhaustive_test proves their accuracy.
#include "base/maths.h"

using namespace odraz;

TEST(Maths, ScalarAndLanesAgreeToTheBit) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> any(-100, 100), positive(1e-6f, 1e6f);
    for (int i = 0; i < 200000; ++i) {
        float x = any(random), p = positive(random);
        EXPECT_EQ(bits(sin(x)), bits(sin(broadcast(x)))[3]);
        EXPECT_EQ(bits(cos(x)), bits(cos(broadcast(x)))[3]);
        EXPECT_EQ(bits(exp2(x)), bits(exp2(broadcast(x)))[3]);
        EXPECT_EQ(bits(log2(p)), bits(log2(broadcast(p)))[3]);
        EXPECT_EQ(bits(pow(p, 0.4f)), bits(pow(broadcast(p), 0.4f))[3]);
    }
}

TEST(Maths, MeetsItsExactValues) {
    EXPECT_EQ(sin(0.f), 0);
    EXPECT_EQ(cos(0.f), 1);
    for (int i = -126; i < 128; ++i) {
        EXPECT_EQ(exp2((float)i), std::ldexp(1.f, i));
        EXPECT_EQ(log2(std::ldexp(1.f, i)), i);
    }
    EXPECT_EQ(pow(1.f, 300.f), 1);
}

TEST(Maths, StaysFiniteOutsideItsRange) {
    EXPECT_EQ(exp2(-1e30f), std::ldexp(1.f, -126));
    EXPECT_TRUE(std::isfinite(exp2(1e30f)));
    EXPECT_EQ(log2(0.f), -126);
    EXPECT_EQ(log2(-5.f), -126);
    EXPECT_EQ(pow(0.f, 5.f), std::ldexp(1.f, -126));
    EXPECT_FALSE(std::isnan(exp2(NAN)));
    EXPECT_FALSE(std::isnan(log2(NAN)));
}

TEST(Maths, SmoothstepIsFlatAtBothEnds) {
    EXPECT_EQ(smoothstep(2.f, 4.f, 1.f), 0);
    EXPECT_EQ(smoothstep(2.f, 4.f, 3.f), 0.5f);
    EXPECT_EQ(smoothstep(2.f, 4.f, 5.f), 1);
    EXPECT_LT(smoothstep(0.f, 1.f, 0.001f), 1e-5f);
}
