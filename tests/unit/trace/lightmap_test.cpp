// Tests light on surfaces, the form factor of a ball, and the sky.
#include "trace/scene/lightmap.h"
#include "trace/scene/sky.h"
#include "trace/shade/ball.h"

using namespace odraz;

struct Sheet {
    Chart chart = {};
    std::vector<float> texels, patches;
    Lightmap map = {};
    // An upright chart of size 3 x 1 with 6 x 4 cells, away from the origin; each corner has value(i, j)
    template <class Value> explicit Sheet(Value value) {
        chart.corner = {1, 2, -3};
        chart.u = {0, 0, 1}, chart.v = {0, 1, 0}, chart.n = {-1, 0, 0};
        chart.width = 3, chart.height = 1;
        chart.across = 6, chart.down = 4;
        chart.patchesAcross = 2, chart.patchesDown = 2;
        chart.firstTexel = 5;
        chart.firstPatch = 100;
        texels.resize((size_t)(5 + chart.texels()), -99.f);
        patches.resize(104, -99.f);
        for (int j = 0; j <= 4; ++j)
            for (int i = 0; i <= 6; ++i) texels[(size_t)chart.texel(i, j)] = value(i, j);
        for (int k = 0; k < 4; ++k) patches[(size_t)(100 + k)] = (float)k;
        map.charts = &chart;
        for (int k = 0; k < 3; ++k) map.plane[k] = texels.data(), map.patch[k] = patches.data();
    }
    float at(float s, float t) const { return lightAt(map, chart, broadcast(chart.at(s, t))).y[3]; }
    // Returns the patch at (s, t), seen along d, and the share of a sample there that no line covers.
    std::pair<int, float> patchAndClear(float s, float t, Vec3 d, float cosine, float width) const {
        Float8 clear;
        Int8 patch = patchAt(chart, broadcast(chart.at(s, t)), broadcast(d), broadcast(cosine),
                             broadcast(width), clear);
        return {(int)patch[0], (float)clear[0]};
    }
};

TEST(Lightmap, IsBilinearBetweenCorners) {
    Sheet sheet([](int i, int j) { return (float)(10 * i + j); });
    for (float s = 0; s <= 3; s += 0.1f)
        for (float t = 0; t <= 1; t += 0.05f)
            EXPECT_NEAR(sheet.at(s, t), 10 * (s * 2) + t * 4, 1e-4f) << s << ' ' << t;
    EXPECT_FLOAT_EQ(sheet.at(0, 0), 0);
    EXPECT_FLOAT_EQ(sheet.at(3, 1), 64);
    EXPECT_FLOAT_EQ(sheet.at(-1, -1), 0); // outside: the border's value, never another chart's texels
    EXPECT_FLOAT_EQ(sheet.at(9, 9), 64);
    EXPECT_FLOAT_EQ(sheet.at(std::nanf(""), 0.5f), sheet.at(0, 0)); // NaN gives a number
}

TEST(Lightmap, LaysPatchesOverItAsAMosaic) {
    Sheet sheet([](int, int) { return 7.f; });
    sheet.map.mosaic = 1;
    sheet.map.sharpness = kFlat;
    for (float s = 0.013f; s < 3; s += 0.1f)
        for (float t = 0.013f; t < 1; t += 0.06f)
            EXPECT_FLOAT_EQ(sheet.at(s, t), (float)(2 * (int)(t * 2) + (int)(s / 1.5f))) << s << ' ' << t;
    sheet.map.mosaic = 0.25f;
    EXPECT_FLOAT_EQ(sheet.at(2, 0.9f), 0.75f * 7 + 0.25f * 3);
    // With sharpness 1 it interpolates between middles of patches
    sheet.map.mosaic = sheet.map.sharpness = 1;
    EXPECT_FLOAT_EQ(sheet.at(0.75f, 0.25f), 0);
    EXPECT_FLOAT_EQ(sheet.at(1.5f, 0.25f), 0.5f);
    EXPECT_FLOAT_EQ(sheet.at(3, 0.5f), 2);
}

TEST(Lightmap, FindsPatchesAndTheLinesBetweenThem) {
    Sheet sheet([](int, int) { return 1.f; });
    const Chart &c = sheet.chart;
    auto patchAndClear = [&](float s, float t, float width = 0.001f) {
        return sheet.patchAndClear(s, t, c.n, 1, width);
    };
    EXPECT_EQ(patchAndClear(0.7f, 0.2f), (std::pair{100, 1.f}));
    EXPECT_EQ(patchAndClear(2.9f, 0.2f).first, 101);
    EXPECT_EQ(patchAndClear(0.1f, 0.9f).first, 102);
    EXPECT_EQ(patchAndClear(2.9f, 0.9f).first, 103);
    EXPECT_NEAR(patchAndClear(1.5f, 0.2f).second, 0, 1e-5f);
    // In a wide sample a line is paler
    EXPECT_GT(patchAndClear(1.5f, 0.25f, 0.5f).second, 0.9f);
    EXPECT_LT(patchAndClear(1.5f, 0.25f, 0.5f).second, 1);
}

// A line between patches, seen straight or at an angle, looks like the mean of many narrow samples over twice
// the width of the sample.
TEST(Lightmap, LinesAreFilteredLikeManySamples) {
    Sheet sheet([](int, int) { return 1.f; });
    const Chart &c = sheet.chart;
    auto clearAt = [&](float s, Vec3 d, float cosine, float width) {
        return (double)sheet.patchAndClear(s, 0.25f, d, cosine, width).second;
    };
    for (float cosine : {1.f, 0.5f, 0.1f})
        for (float width : {0.004f, 0.02f, 0.05f})
            for (float s : {1.3f, 1.45f, 1.49f, 1.5f, 1.52f}) {
                // Along u the footprint gets longer with the angle
                Vec3 d = c.u * std::sqrt(1 - cosine * cosine) - c.n * cosine;
                float wide = 2 * width / cosine;
                double sum = 0;
                constexpr int kSide = 200;
                for (int i = 0; i < kSide; ++i)
                    sum += clearAt(s + wide * (((float)i + 0.5f) / kSide - 0.5f), c.n, 1, 1e-4f);
                EXPECT_NEAR(clearAt(s, d, cosine, width), sum / kSide, 0.02)
                    << cosine << ' ' << width << ' ' << s;
            }
}

// Compares the form factor with a sum over the cone that the ball fills.
TEST(Ball, FormFactorWithAndWithoutTheHorizon) {
    for (double sine2 : {1e-6, 0.01, 0.2, 0.5, 0.9, 0.999})
        for (double cosine = -1; cosine <= 1.0001; cosine += 0.05) {
            double c = std::fmin(cosine, 1.), s = std::sqrt(std::fmax(0., 1 - c * c)),
                   open = 1 - std::sqrt(1 - sine2);
            constexpr int kRings = 200, kSpokes = 400;
            double exact = 0;
            for (int i = 0; i < kRings; ++i)
                for (int k = 0; k < kSpokes; ++k) {
                    double z = 1 - open * (i + 0.5) / kRings, r = std::sqrt(1 - z * z);
                    exact += std::fmax(0., z * c - r * std::cos(2 * M_PI * (k + 0.5) / kSpokes) * s);
                }
            exact *= 2 * open / (kRings * kSpokes);
            double got = (double)ballFormFactor(broadcast((float)c), broadcast((float)sine2))[0];
            EXPECT_NEAR(got, exact, 1e-3 * sine2 + 1e-6) << sine2 << ' ' << c;
        }
    EXPECT_TRUE(std::isfinite(ballFormFactor(broadcast(1.f), broadcast(5.f))[0])); // a point inside the ball
}

TEST(Sky, RisesFromTheHorizonToTheZenith) {
    Sky sky = plainSky({1, 2, 3}, {0, 0, 0});
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{0, 1, 0})).x[0], 0);
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{1, 0, 0})).y[0], 2);
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{0, -1, 0})).z[0],
                    3); // below the horizon the horizon's colour stays
    sky.least = -1;
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{0, -1, 0})).z[0],
                    12); // with `least` = -1 the gradient continues
    sky.least = 0;
    sky.sun = {0.6f, 0.8f, 0};
    sky.glow = sky.near = {0.5f, 0.5f, 0.5f};
    Sky without = plainSky({1, 2, 3}, {0, 0, 0});
    EXPECT_NEAR((double)(radiance(sky, broadcast(sky.sun)).x[0] - radiance(without, broadcast(sky.sun)).x[0]),
                1, 1e-5);
    // The near glow's irradiance on a surface that faces the sun, by the midpoint rule
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        double cosine = (i + 0.5) / 10000;
        sum += std::pow(cosine, 64) * cosine * 2e-4;
    }
    EXPECT_NEAR((double)kNearGlow, sum, 1e-5);
}
