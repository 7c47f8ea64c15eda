// Compares FLIP with its definition: with results of dense two-dimensional filters in double precision, by
// numpy and the paper's formulas, and with values computed by hand.
#include "tools/picture/flip.h"
#include "tools/picture/psnr.h"

using namespace pictures;

using Bytes = std::vector<uint8_t>;
constexpr int kAcross = 72, kDown = 48;

// Makes the pictures of the comparison with dense filters
template <class F> static Bytes picture(F &&of, int width = kAcross, int height = kDown) {
    Bytes all;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) all.push_back((uint8_t)std::min(255, of(x, y, c)));
    return all;
}
static int checks(int x, int y, int c) { return (x / 8 + y / 8) % 2 ? 40 + 60 * c + x : 200 - 30 * c - y; }
static int noise(int x, int y, int c) {
    return (int)(((uint32_t)x * 73856093u ^ (uint32_t)y * 19349663u ^ (uint32_t)(c + 1) * 83492791u) >> 3 &
                 255);
}
static Bytes plain(int r, int g, int b) {
    return picture([&](int, int, int c) { return c == 0 ? r : c == 1 ? g : b; });
}
static double mean(const Bytes &a, const Bytes &b, int width = kAcross, int height = kDown) {
    return meanFlip(see(a, width, height), see(b, width, height));
}

struct Expected {
    const char *name;
    Bytes test;
    double mean, first, middle, last; // FLIP: its mean, and its values at 0,0, at 37,21 and at 71,47
};

TEST(Flip, AgreesWithDenseFiltersInDouble) {
    const Expected all[] = {
        {"moved", picture([](int x, int y, int c) { return checks(x + 1, y, c); }), 0.134411, 0.033976,
         0.135680, 0.663682},
        {"brighter", picture([](int x, int y, int c) { return checks(x, y, c) + 6; }), 0.122334, 0.118573,
         0.116020, 0.128023},
        {"noisy", picture([](int x, int y, int c) { return checks(x, y, c) + noise(x, y, c) / 8; }), 0.246078,
         0.389134, 0.267579, 0.390832},
        {"noise", picture(noise), 0.464465, 0.791629, 0.371377, 0.879153},
    };
    SeenPicture reference = see(picture(checks), kAcross, kDown);
    for (const Expected &e : all) {
        SeenPicture test = see(e.test, kAcross, kDown);
        std::vector<float> errors = flip(reference, test);
        EXPECT_NEAR(meanFlip(reference, test), e.mean, 2e-6) << e.name;
        EXPECT_NEAR(errors[0], e.first, 2e-5) << e.name;
        EXPECT_NEAR(errors[21 * kAcross + 37], e.middle, 2e-5) << e.name;
        EXPECT_NEAR(errors.back(), e.last, 2e-5) << e.name;
    }
}

// Plain pictures have no features, and filters do not change them. So FLIP is the distance of two colours,
// here from the tables of CIELAB (D65): green 87.737 -86.185 83.181, blue 32.303 79.197 -107.864,
// red 53.233 80.109 67.220
TEST(Flip, OfPlainColoursIsTheirDistanceByHand) {
    struct Lab {
        double l, a, b;
    } green = {87.737, -86.185, 83.181}, blue = {32.303, 79.197, -107.864}, red = {53.233, 80.109, 67.220},
      white = {100, 0, 0}, black = {0, 0, 0};
    auto apart = [](Lab p, Lab q) {
        return std::pow(std::fabs(p.l - q.l) + std::hypot(p.l * p.a - q.l * q.a, p.l * p.b - q.l * q.b) / 100,
                        0.7);
    };
    auto expected = [&](Lab p, Lab q) {
        double most = apart(green, blue), e = apart(p, q), knee = 0.4 * most;
        return e < knee ? 0.95 * e / knee : 0.95 + 0.05 * (e - knee) / (most - knee);
    };
    EXPECT_NEAR(mean(plain(0, 255, 0), plain(0, 0, 255)), 1, 1e-5);
    EXPECT_NEAR(mean(plain(0, 0, 0), plain(255, 255, 255)), expected(black, white), 1e-4);
    EXPECT_NEAR(expected(black, white), 0.9674, 1e-4);
    EXPECT_NEAR(mean(plain(255, 0, 0), plain(255, 255, 255)), expected(red, white), 1e-4);
    EXPECT_NEAR(mean(plain(255, 0, 0), plain(0, 0, 0)), expected(red, black), 1e-4);
    // Grey 119 has L* = 50.03, grey 120 50.43: below the knee
    EXPECT_NEAR(mean(plain(119, 119, 119), plain(120, 120, 120)), expected({50.034, 0, 0}, {50.431, 0, 0}),
                1e-4);
}

TEST(Flip, IsNothingForEqualPicturesAndTheSameBothWays) {
    Bytes a = picture(checks), b = picture(noise);
    EXPECT_EQ(mean(a, a), 0);
    EXPECT_EQ(mean(b, b), 0);
    EXPECT_EQ(mean(a, b), mean(b, a));
    for (float e : flip(see(a, kAcross, kDown), see(b, kAcross, kDown))) EXPECT_TRUE(e > 0 && e <= 1);
}

// Filters sum to 1 and are isotropic: a rotated picture has the same error
TEST(Flip, DoesNotDependOnTheDirection) {
    auto turned = [](auto &&of) {
        return picture([&](int x, int y, int c) { return of(kAcross - 1 - y, kDown - 1 - x, c); }, kDown,
                       kAcross);
    };
    EXPECT_NEAR(mean(turned(checks), turned(noise), kDown, kAcross), mean(picture(checks), picture(noise)),
                1e-6);
}

// An error at an edge counts more than the same error on a slope
TEST(Flip, SeesEdgesMoreThanSlopes) {
    auto grey = [](int, int, int) { return 110; };
    auto step = [](int x, int, int) { return x < kAcross / 2 ? 105 : 115; };
    auto slope = [](int x, int, int) { return 105 + x * 10 / kAcross; };
    SeenPicture reference = see(picture(grey), kAcross, kDown);
    auto middle = [&](const Bytes &test) {
        return flip(reference, see(test, kAcross, kDown))[24 * kAcross + 33];
    };
    EXPECT_GT(middle(picture(step)), 1.5 * middle(picture(slope)));
}

TEST(Psnr, OfLinearLightCountsAStepMoreWhereItIsBright) {
    Bytes dark = plain(20, 20, 20), darker = plain(10, 10, 10), bright = plain(240, 240, 240),
          brighter = plain(250, 250, 250);
    EXPECT_DOUBLE_EQ(psnr(dark, darker), psnr(bright, brighter));
    // ((240/255 + .055) / 1.055)^2.4 = .87137; for 250 it is .95597, for 20 .0069954, for 10 .0030353
    EXPECT_NEAR(linearPsnr(bright, brighter), -20 * std::log10(0.95597 - 0.87137), 1e-2);
    EXPECT_NEAR(linearPsnr(dark, darker), -20 * std::log10(0.0069954 - 0.0030353), 1e-2);
    EXPECT_EQ(linearPsnr(dark, dark), INFINITY);
}
