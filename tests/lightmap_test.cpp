// Light kept on surfaces, the form factor of a ball, and the sky.
#include "trace/ball.h"
#include "trace/lightmap.h"
#include "trace/sky.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

using namespace odraz;

namespace {

struct Sheet {
    Chart chart = {};
    std::vector<float> texels;
    Lightmap map = {};
    // 6 x 4 elements over 3 x 1, standing upright somewhere; value(i, j) of each, the ring as its border
    template <class Value> explicit Sheet(Value value) {
        chart.corner = {1, 2, -3};
        chart.u = {0, 0, 1}, chart.v = {0, 1, 0}, chart.n = {-1, 0, 0};
        chart.width = 3, chart.height = 1;
        chart.across = 6, chart.down = 4;
        chart.patchAcross = 3, chart.patchDown = 2;
        chart.firstTexel = 5;
        chart.firstPatch = 100;
        texels.resize((size_t)(5 + chart.texels()), -99.f);
        for (int j = -1; j <= 4; ++j)
            for (int i = -1; i <= 6; ++i)
                texels[(size_t)chart.texel(i, j)] =
                    value(std::min(std::max(i, 0), 5), std::min(std::max(j, 0), 3));
        map = {&chart, {texels.data(), texels.data(), texels.data()}, 1};
    }
    float at(float s, float t) const { return lightAt(map, chart, broadcast(chart.at(s, t))).y[3]; }
};

} // namespace

TEST(Lightmap, IsBilinearBetweenMiddlesAndFlatAtTheBorder) {
    Sheet sheet([](int i, int j) { return (float)(10 * i + j); });
    for (float s = 0.25f; s <= 2.75f; s += 0.1f)
        for (float t = 0.125f; t <= 0.875f; t += 0.05f)
            EXPECT_NEAR(sheet.at(s, t), 10 * (s * 2 - 0.5f) + t * 4 - 0.5f, 1e-4f) << s << ' ' << t;
    EXPECT_FLOAT_EQ(sheet.at(0, 0), 0);
    EXPECT_FLOAT_EQ(sheet.at(3, 1), 53);
    EXPECT_FLOAT_EQ(sheet.at(-1, -1), 0); // outside: the border, never another chart's texels
    EXPECT_FLOAT_EQ(sheet.at(9, 9), 53);
}

TEST(Lightmap, SharpenedItIsAMosaic) {
    Sheet sheet([](int i, int j) { return (float)(10 * i + j); });
    sheet.map.sharpness = kFlat;
    for (float s = 0.013f; s < 3; s += 0.1f)
        for (float t = 0.013f; t < 1; t += 0.06f)
            EXPECT_FLOAT_EQ(sheet.at(s, t), (float)(10 * (int)(s * 2) + (int)(t * 4))) << s << ' ' << t;
}

TEST(Lightmap, KnowsItsPatchesAndTheLinesBetweenThem) {
    Sheet sheet([](int, int) { return 1.f; });
    const Chart &c = sheet.chart;
    auto look = [&](float s, float t, float width, float &clear) {
        Float8 all;
        int patch = patchAt(c, broadcast(c.at(s, t)), broadcast(width), all)[0];
        clear = all[0];
        return patch;
    };
    float clear;
    EXPECT_EQ(look(0.7f, 0.2f, 0.001f, clear), 100);
    EXPECT_FLOAT_EQ(clear, 1);
    EXPECT_EQ(look(2.9f, 0.2f, 0.001f, clear), 101);
    EXPECT_EQ(look(0.1f, 0.9f, 0.001f, clear), 102);
    EXPECT_EQ(look(2.9f, 0.9f, 0.001f, clear), 103);
    look(1.5f, 0.2f, 0.001f, clear);
    EXPECT_NEAR(clear, 0, 1e-5f);
    // Seen from afar a line pales as it is spread out
    look(1.5f, 0.25f, 0.5f, clear);
    EXPECT_GT(clear, 0.9f);
    EXPECT_LT(clear, 1);
}

// Against a sum over the cone that the ball fills.
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
    EXPECT_TRUE(std::isfinite(ballFormFactor(broadcast(1.f), broadcast(5.f))[0])); // inside it
}

TEST(Sky, RisesFromTheHorizonToTheZenith) {
    Sky sky = plainSky({1, 2, 3}, {0, 0, 0});
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{0, 1, 0})).x[0], 0);
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{1, 0, 0})).y[0], 2);
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{0, -1, 0})).z[0], 3); // no ground: the horizon goes on
    sky.ground = {};
    EXPECT_FLOAT_EQ(radiance(sky, broadcast(Vec3{0, -1, 0})).z[0], 0);
    sky.sun = {0.6f, 0.8f, 0};
    sky.glow = {1, 1, 1};
    EXPECT_GT(radiance(sky, broadcast(sky.sun)).x[0],
              radiance(sky, broadcast(Vec3{-0.6f, 0.8f, 0})).x[0] + 1);
}
