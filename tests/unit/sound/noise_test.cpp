// Tests bands of noise: the filter's response matches its closed form and stays bounded when swept, and all
// bands differ.
#include "base/maths.h"
#include "base/random.h"
#include "tests/support/figure.h"
#include "tests/support/voice.h"

using namespace odraz;

constexpr Instrument kBands = {.noise = 0.2f, .stretch = 1.3f, .decay = 1e6f, .spread = 1};

// The bilinear transform of the analogue band-pass g s / (1 + k s + s^2) is a filter with two poles. In
// double precision, it gives the same samples for the same noise.
TEST(Noise, MatchesTheFiltersClosedForm) {
    for (float key : {30.f, 69.f, 93.f}) {
        std::unique_ptr<Voice> voice = begun({&kBands, key, 1, 100, 0});
        Uint8 phase = voice->group[0].phase;
        Float8 amplitude = voice->group[0].amplitude;
        std::vector<Float8> out = rendered(*voice, 0.5);
        double error = 0, power = 0;
        for (int lane = 0; lane < 8; ++lane) {
            double g = std::tan(M_PI * (double)voice->group[0].turn[lane] / 4294967296.),
                   k = (double)kBands.noise, a0 = 1 + k * g + g * g, a1 = 2 * (g * g - 1),
                   a2 = 1 - k * g + g * g;
            double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
            for (size_t n = 0; n < out.size(); ++n) {
                double x = (double)(int32_t)pcg(phase[lane] + (uint32_t)n) / 2147483648.;
                double y = (g * (x - x2) - a1 * y1 - a2 * y2) / a0;
                x2 = x1, x1 = x, y2 = y1, y1 = y;
                if (n < kBlock) continue; // skip the attack
                double got = (double)out[n][lane] / (double)amplitude[lane];
                error += (got - y) * (got - y);
                power += y * y;
            }
        }
        expectAtMost("key " + testing::PrintToString(key) + ": share of the power", error / power, 1e-7);
    }
}

// A sweep over the whole range within a block or two, up or down, neither rings nor grows.
TEST(Noise, StaysBoundedHoweverItIsSwept) {
    for (float bend : {-0.99f, 0.f, 5.f})
        for (float time : {-0.5f, 0.002f, 1.f})
            for (float width : {0.02f, 0.5f, 2.f}) {
                Instrument kind = kBands;
                kind.noise = width, kind.bend = bend, kind.bendTime = time;
                double most = 0;
                for (Float8 x : rendered(*begun({&kind, 69, 1, 100, 0}), 3))
                    for (int lane = 0; lane < 8; ++lane) most = std::max(most, std::fabs((double)x[lane]));
                EXPECT_LT(most, 1.2 * 1.5 / (double)width) << bend << ", " << time;
                EXPECT_GT(most, 0.01) << bend << ", " << time;
            }
}

TEST(Noise, DiffersOnBothSidesAndInAllBands) {
    std::vector<Float8> x = rendered(*begun({&kBands, 69, 1, 100, 1}), 1);
    for (int a = 0; a < 8; ++a)
        for (int b = 0; b < a; ++b) {
            double aa = 0, bb = 0, ab = 0;
            for (Float8 v : x) {
                aa += (double)v[a] * (double)v[a], bb += (double)v[b] * (double)v[b];
                ab += (double)v[a] * (double)v[b];
            }
            EXPECT_LT(std::fabs(ab) / std::sqrt(aa * bb), 0.2) << a << ", " << b;
        }
}
