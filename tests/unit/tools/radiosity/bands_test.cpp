// Compares spherical harmonics of six bands, and environments projected onto them, with the addition theorem,
// Parseval's theorem and closed forms.
#include "tests/support/open_room.h"
#include "tools/radiosity/transfer/environment.h"

using namespace odraz;
using namespace odraz::radiosity;

// The sum over a band's orders is (2 l + 1) / 4 pi times the Legendre polynomial of the angle's cosine. This
// holds only for orthonormal functions.
TEST(Bands, ObeyTheAdditionTheorem) {
    Dice dice(1);
    double worst = 0;
    for (int i = 0; i < 1000; ++i) {
        Vec3 a = dice.direction(), b = dice.direction();
        Float8 ya[kMostSh], yb[kMostSh];
        evaluateBands(broadcast(a), kMostBands, ya);
        evaluateBands(broadcast(b), kMostBands, yb);
        for (int l = 0; l < kMostBands; ++l) {
            double sum = 0;
            for (int k = l * l; k < (l + 1) * (l + 1); ++k) sum += (double)ya[k][0] * (double)yb[k][0];
            worst =
                std::max(worst, std::fabs(sum - (2 * l + 1) / (4 * M_PI) * legendre(l, (double)dot(a, b))));
        }
    }
    EXPECT_LT(worst, 2e-6);
}

TEST(Bands, TurnWithTheirLight) {
    Dice dice(2);
    for (int bands = 1; bands <= kMostBands; ++bands) {
        BandLight light = randomLight(bands, dice);
        Vec3 a = dice.direction(), b = dice.direction();
        auto angle = (double)dice(-180, 180), other = (double)dice(-180, 180);
        Mat3 turn = turnAbout(b, other) * turnAbout(a, angle);
        BandLight after = turned(light, bands, turn);
        for (int i = 0; i < 50; ++i) {
            Vec3 d = dice.direction();
            Rgb was = radiance(light, bands, d), is = radiance(after, bands, turn * d);
            EXPECT_LT(length(was - is), 3e-5f) << bands;
        }
        BandLight back = turned(after, bands, turnAbout(a, -angle) * turnAbout(b, -other));
        for (int k = 0; k < bands * bands; ++k) EXPECT_LT(length(back[(size_t)k] - light[(size_t)k]), 2e-5f);
    }
}

// A picture of a band-limited light has the light's coefficients and all of its energy. A small bright spot
// has little energy in the bands, by Parseval's theorem.
TEST(Environment, IsProjected) {
    for (bool upIsZ : {false, true}) {
        Dice dice(3);
        BandLight light = randomLight(kMostBands, dice);
        SkyPicture sky = pictureOf(light, kMostBands, upIsZ);
        pictures::Picture picture = {sky.width, sky.height};
        for (const Rgb &c : sky.pixels) picture.light.insert(picture.light.end(), {c.x, c.y, c.z});
        Projected p = project(picture, upIsZ);
        for (int k = 0; k < kMostSh; ++k)
            EXPECT_LT(length(p.light[(size_t)k] - light[(size_t)k]), 2e-4f) << k;
        EXPECT_NEAR(p.held[kMostBands - 1], 1, 1e-4);
        for (int l = 1; l < kMostBands; ++l) EXPECT_GT(p.held[l], p.held[l - 1]);
        auto energy = [&](int count) {
            return std::accumulate(light.begin(), light.begin() + count, 0.,
                                   [](double sum, const Rgb &c) { return sum + (double)dot(c, c); });
        };
        EXPECT_NEAR(p.held[1], energy(4) / energy(kMostSh), 1e-4);
    }
    // A row of pixels around the zenith is a disc. Its energy in a band follows from an integral of the
    // Legendre polynomial
    pictures::Picture disc = {64, 32};
    disc.light.resize(disc.pixels() * 3);
    std::fill(disc.light.begin(), disc.light.begin() + (ptrdiff_t)64 * 3, 100.f);
    Projected p = project(disc, false);
    double rim = std::cos(M_PI / 32), held = 0;
    for (int l = 0; l < kMostBands; ++l) {
        double integral = l ? (legendre(l - 1, rim) - legendre(l + 1, rim)) / (2 * l + 1) : 1 - rim;
        held += (2 * l + 1) / (4 * M_PI) * std::pow(2 * M_PI * integral, 2) / (2 * M_PI * (1 - rim));
        EXPECT_NEAR(p.held[l], held, 2e-5) << l;
    }
}
