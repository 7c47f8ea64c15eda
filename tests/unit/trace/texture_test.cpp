// Compares noise with a plain implementation in double precision; checks noise and materials by statistics.
#include "show/materials.h"
#include "tests/support/dice.h"
#include "tools/support/vec3d.h"
#include "trace/texture/noise.h"

using namespace odraz;

static float noiseAt(double x, double y, double z) {
    return noise({broadcast((float)x), broadcast((float)y), broadcast((float)z)})[0];
}

// Returns the noise in double precision, computed corner by corner.
static double plainNoise(double x, double y, double z) {
    double cell[3] = {std::floor(x), std::floor(y), std::floor(z)},
           f[3] = {x - cell[0], y - cell[1], z - cell[2]}, sum = 0;
    auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    for (int corner = 0; corner < 8; ++corner) {
        int o[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
        uint32_t h = (uint32_t)(int)(cell[0] + o[0]) * 0x8da6b343u +
                     (uint32_t)(int)(cell[1] + o[1]) * 0xd8163841u +
                     (uint32_t)(int)(cell[2] + o[2]) * 0xcb1ab31fu;
        h = (h ^ h >> 15) * 0x2c1b3c6du;
        double p[3] = {f[0] - o[0], f[1] - o[1], f[2] - o[2]}, weight = 1;
        for (int k = 0; k < 3; ++k) weight *= o[k] ? fade(f[k]) : 1 - fade(f[k]);
        // The gradient: a corner of a cube, selected by three bits and rotated about three axes
        double g[3];
        for (int k = 0; k < 3; ++k) g[k] = (h >> (29 + k) & 1 ? 1 : -1) * std::sqrt(2 / 3.);
        auto turn = [&](double &a, double &b, double angle) {
            double was = a;
            a = std::cos(angle) * a - std::sin(angle) * b;
            b = std::sin(angle) * was + std::cos(angle) * b;
        };
        turn(g[0], g[1], 0.8);
        turn(g[2], g[0], 0.35);
        turn(g[1], g[2], 0.5);
        sum += weight * (g[0] * p[0] + g[1] * p[1] + g[2] * p[2]);
    }
    return sum;
}

// Returns the mean of colourAt(points) over random points.
template <class ColourAt> Vec3d meanColourAt(Dice &dice, int packets, ColourAt colourAt) {
    Vec3d sum = {};
    for (int i = 0; i < packets; ++i) {
        Vec3x8 p;
        for (int k = 0; k < 8; ++k) setLane(p, k, dice.point(40));
        Rgb8 c = colourAt(p);
        sum = sum + toDouble({total(c.x), total(c.y), total(c.z)});
    }
    return sum / (8. * packets);
}

TEST(Noise, AgreesWithThePlainImplementation) {
    Dice dice(3);
    for (int i = 0; i < 20000; ++i) {
        Vec3 p = dice.point(200);
        ASSERT_NEAR(noiseAt(p.x, p.y, p.z), plainNoise(p.x, p.y, p.z), 1e-4);
    }
}

TEST(Noise, IsZeroOnTheLatticeAndBoundedWithMeanZero) {
    for (int i = -9; i < 9; ++i) EXPECT_EQ(noiseAt(i, 3 * i, -i), 0);
    Dice dice(4);
    double sum = 0, squares = 0, most = 0;
    constexpr int kCount = 200000;
    for (int i = 0; i < kCount; ++i) {
        double n = noise(broadcast(dice.point(500)))[0];
        sum += n, squares += n * n, most = std::fmax(most, std::fabs(n));
    }
    EXPECT_NEAR(sum / kCount, 0, 0.005);
    EXPECT_GT(most, 0.7);
    EXPECT_LE(most, 1);
    EXPECT_NEAR(std::sqrt(squares / kCount), 0.25, 0.04);
}

TEST(Noise, LooksAlikeAlongEveryAxis) {
    Dice dice(5);
    Vec3 slope = {};
    for (int i = 0; i < 60000; ++i) {
        Vec3 p = dice.point(500);
        // Lanes 0 to 2 have a step along one axis each, the others have none
        Float8 at = noise(broadcast(p) + Vec3x8{Float8{0.01f}, Float8{0, 0.01f}, Float8{0, 0, 0.01f}});
        Vec3 d = Vec3{at[0] - at[3], at[1] - at[3], at[2] - at[3]};
        slope += d * d;
    }
    EXPECT_NEAR(slope.x / slope.y, 1, 0.1);
    EXPECT_NEAR(slope.z / slope.y, 1, 0.1);
}

TEST(Noise, StaysFiniteFarOut) {
    for (float x : {1e5f, 1e8f, 1e15f, -1e20f, 3e38f}) {
        Float8 n = noise({broadcast(x), broadcast(-x), broadcast(0.5f)});
        EXPECT_LE(std::fabs(n[0]), 1) << x;
    }
}

TEST(Noise, OctavesFadeBeforeTheyAlias) {
    Vec3x8 p = {toFloat(kLanes) * 0.37f, broadcast(0.2f), broadcast(0.9f)};
    Float8 wide = fractalNoise(p, 6, broadcast(2.f)), fine = fractalNoise(p, 6, broadcast(1e-4f));
    for (int k = 0; k < 8; ++k) EXPECT_EQ(wide[k], 0);
    EXPECT_NE(fine[1], 0);
    EXPECT_EQ(bandLimit(broadcast(0.1f), 1)[0], 1);
    EXPECT_EQ(bandLimit(broadcast(0.8f), 1)[0], 0);
}

// White and black squares.
static Material checker(float cell) {
    return {.texture = {Pattern::Plain, 1, {{1, 1, 1}}}, .other = {Pattern::Plain, 1, {}}, .cell = cell};
}

// Returns the difference between the filtered checker and the mean of the sharp one, at a point seen along d.
// The footprint's width across the view is `across`.
static double offAverage(float cell, Vec3 point, Vec3 d, float across) {
    float cosine = -d.y, flat = std::hypot(d.x, d.z);
    Vec3 ahead = flat > 0 ? Vec3{d.x / flat, 0, d.z / flat} : Vec3{1, 0, 0}, aside = {-ahead.z, 0, ahead.x};
    double sum = 0;
    constexpr int kSide = 64;
    for (int a = 0; a < kSide; ++a)
        for (int b = 0; b < kSide; ++b) {
            float along = (((float)a + 0.5f) / kSide - 0.5f) * across / cosine;
            Vec3 p = point + ahead * along + aside * ((((float)b + 0.5f) / kSide - 0.5f) * across);
            sum += ((int)std::floor(p.x / cell) + (int)std::floor(p.z / cell)) & 1 ? 0 : 1;
        }
    Int8 square;
    Rgb8 filtered =
        albedo(checker(cell), broadcast(point), broadcast(d), broadcast(cosine), broadcast(across), square);
    return filtered.x[0] - sum / (kSide * kSide);
}

TEST(Checker, IsFilteredLikeManySamples) {
    Dice dice(6);
    for (int i = 0; i < 200; ++i) {
        Vec3 p = {dice(-3, 3), 0, dice(-3, 3)};
        ASSERT_NEAR(offAverage(0.5f, p, {0, -1, 0}, dice(0.01f, 1.5f)), 0, 0.035);
    }
}

// Along its diagonals the two square waves of a checker change together, so the product of their means is
// wrong.
TEST(Checker, IsFilteredAlongASlantedView) {
    Dice dice(7);
    for (float degrees : {0.f, 20.f, 45.f, 70.f}) {
        float angle = degrees / 180 * (float)M_PI;
        Vec3 d = normalize(Vec3{std::cos(angle), -0.06f, std::sin(angle)});
        double squares = 0;
        constexpr int kPlaces = 200;
        for (int i = 0; i < kPlaces; ++i)
            squares += std::pow(offAverage(1, {dice(-3, 3), 0, dice(-3, 3)}, d, 0.1f), 2);
        EXPECT_LT(std::sqrt(squares / kPlaces), 0.07) << degrees; // the product of means: 0.24 at 45 degrees
    }
}

TEST(Materials, AreColoursEverywhere) {
    for (const Material &m :
         {kDarkMarble, kBoards, metal(true, 0.4f), kSlate, kGranite, kOak, kGlass, kMirror, kCopper})
        for (float far : {0.f, 3.3f, 1e3f, 1e9f})
            for (float width : {0.f, 1e-3f, 1.f, 1e6f})
                for (float cosine : {0.f, 1e-4f, 1.f}) {
                    Int8 cell;
                    Vec3x8 p = {toFloat(kLanes) * 0.3f + far, toFloat(kLanes) * 0.1f, broadcast(-far)};
                    Rgb8 c = albedo(m, p, broadcast(Vec3{0.6f, -0.8f, 0}), broadcast(cosine),
                                    broadcast(width), cell);
                    for (int k = 0; k < 8; ++k)
                        for (float v : {c.x[k], c.y[k], c.z[k]}) ASSERT_TRUE(v >= 0 && v <= 1) << v;
                }
}

// The shares in a pattern's row were measured. They sum to 1.
TEST(Patterns, ShowTheirColoursInTheSharesOfTheirRows) {
    Dice dice(8);
    for (const PatternTraits &row : kPatterns) {
        EXPECT_NEAR(row.shares[0] + row.shares[1] + row.shares[2] + row.shares[3], 1, 1e-6);
        Texture t = {
            .pattern = row.pattern, .scale = 1, .palette = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
        auto shares = meanColourAt(dice, 10000, [&](Vec3x8 p) { return colour(t, p, broadcast(1e-3f)); });
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR((double)row.shares[c], shares[c], 0.03) << (int)row.pattern << ' ' << c;
    }
}

// Radiosity uses the mean of a pattern: it must be the mean of the colours that are seen.
TEST(Material, MeanAlbedoIsTheMean) {
    Dice dice(5);
    for (const Material &m :
         {kDarkMarble, kSlate, kGranite, kOak, kLimestone, kBeamAcross, kBoards, kHallFloor}) {
        auto mean = meanColourAt(dice, 20000, [&](Vec3x8 p) {
            Int8 cell;
            return albedo(m, p, broadcast(Vec3{0, -1, 0}), broadcast(1.f), broadcast(1e-3f), cell);
        });
        Vec3d stated = toDouble(meanAlbedo(m));
        for (size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(stated[c], mean[c], 0.04 * stated[c]) << (int)m.texture.pattern;
    }
}
