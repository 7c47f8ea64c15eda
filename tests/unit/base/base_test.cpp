#include "base/arena.h"
#include "base/random.h"
#include "base/text.h"
#include "base/vec3.h"

#include <limits>

using namespace odraz;

TEST(Float8, SelectsAndMasksByLane) {
    Float8 x = toFloat(kLanes);
    Float8 y = select(x > 3.f, x, -1.f);
    for (int i = 0; i < 8; ++i) EXPECT_EQ(y[i], i > 3 ? i : -1);
    EXPECT_EQ(laneBits(kLanes < 3), 7);
    EXPECT_TRUE(all(kLanes >= 0));
    EXPECT_FALSE(any(kLanes < 0));
}

TEST(Float8, BroadcastKeepsSignedZeroAndNaN) {
    EXPECT_TRUE(std::signbit(broadcast(-0.f)[5]));
    EXPECT_TRUE(std::isnan(broadcast(NAN)[2]));
}

TEST(Float8, RoundsHalvesToEvenLikeTheScalar) {
    for (float x : {0.5f, 1.5f, 2.5f, -0.5f, -1.5f, 0.49999997f, 1e9f}) {
        EXPECT_EQ(round(broadcast(x))[0], std::nearbyint(x));
        EXPECT_EQ(round(x), std::nearbyint(x));
    }
}

TEST(Float8, MinAndMaxTakeTheSecondOperandOfNaN) {
    EXPECT_EQ(min(broadcast(NAN), broadcast(3.f))[0], 3);
    EXPECT_EQ(min(NAN, 3.f), 3);
    EXPECT_EQ(saturate(broadcast(NAN))[0], 0);
}

TEST(Vec3, NormalizeGivesUnitLengthOrZeroNeverNaN) {
    for (float s : {1e-12f, 1e-3f, 1.f, 1e6f, 1e15f})
        EXPECT_NEAR(length(normalize(Vec3{s, -2 * s, 0.5f * s})), 1, 2e-7);
    Vec3 none = normalize(Vec3{0, 0, 0}), tiny = normalize(Vec3{1e-30f, 0, 0});
    EXPECT_EQ(length(none), 0);
    EXPECT_EQ(length(tiny), 0);
}

TEST(Vec3, RotationsComposeAndInvert) {
    Mat3 a = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}, b = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    Vec3 p = {1, 2, 3}, q = (a * b) * p, r = a * (b * p), back = transposeTimes(a, a * p);
    for (float d : {length(q - r), length(back - p)}) EXPECT_EQ(d, 0);
}

TEST(Random, IsUniformAndTheSameForLanes) {
    int bins[16] = {};
    for (uint32_t i = 0; i < 160000; ++i) ++bins[(int)(unitFloat(pcg(i)) * 16)];
    for (int n : bins) EXPECT_NEAR(n, 10000, 500); // five sigma
    Uint8 lanes = pcg((Uint8)(kLanes + 41));
    for (uint32_t i = 0; i < 8; ++i) EXPECT_EQ(lanes[i], pcg(i + 41));
    EXPECT_LT(unitFloat(0xffffffffu), 1.f);
}

TEST(Arena, AlignsAndReturnsNullWhenFull) {
    alignas(64) unsigned char block[256] = {};
    Arena arena = {block, sizeof block, 0};
    auto *a = arena.allocate<char>(3), *b = arena.allocate<char>(1);
    EXPECT_EQ((char *)block, a);
    EXPECT_EQ((char *)block + 64, b);
    EXPECT_FALSE(arena.full);
    EXPECT_EQ(arena.allocate<double>(17), nullptr);
    EXPECT_TRUE(arena.full);
    EXPECT_NE(arena.allocate<double>(16), nullptr);
    EXPECT_EQ(arena.allocate<char>(1), nullptr);
    EXPECT_EQ(arena.allocate<char>(std::numeric_limits<size_t>::max()), nullptr);
}

TEST(Text, FormatsAndCutsOff) {
    Text<64> t;
    (t << "n=" << -42 << ' ').decimal(3.14159, 2) << ' ';
    t.number(7, 3);
    EXPECT_STREQ(t.data, "n=-42 3.14 007");
    EXPECT_STREQ((Text<64>() << INT64_MIN).data, "-9223372036854775808");
    Text<4> small;
    small << "abcdef";
    EXPECT_STREQ(small.data, "abc");
    Text<16> carry;
    EXPECT_STREQ(carry.decimal(1.996, 2).data, "2.00");
}
