// Compares spherical harmonics with the recurrence in double precision, windows with their closed form, and
// projected skies with the originals.
#include "transfer/spherical_harmonics.h"

#include "tests/support/dice.h"
#include "tests/support/figure.h"

using namespace odraz;

// Returns directions all over the sphere, including poles and axes.
static std::vector<Vec3> directions() {
    std::vector<Vec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    Dice dice(7);
    for (int i = 0; i < 1000; ++i) {
        float y = dice(-1, 1), a = dice(0, 6.2831853f), r = std::sqrt(1 - y * y);
        all.push_back({r * std::sin(a), y, r * std::cos(a)});
    }
    return all;
}

// Evaluates a function by the recurrence of the associated Legendre functions (Press et al., "Numerical
// Recipes", 6.8), in double.
static double byRecurrence(int l, int m, Vec3 d) {
    int order = std::abs(m);
    double z = (double)d.y, sine = std::sqrt(std::fmax(0, 1 - z * z)), pmm = 1;
    for (int i = 1; i <= order; ++i) pmm *= -(2 * i - 1) * sine;
    double p = pmm, before = 0;
    for (int k = order + 1; k <= l; ++k) {
        double next = ((2 * k - 1) * z * p - (k + order - 1) * before) / (k - order);
        before = p, p = next;
    }
    double ratio = 1;
    for (int i = l - order + 1; i <= l + order; ++i) ratio /= i;
    double around = std::atan2((double)d.x, (double)d.z), k = std::sqrt((2 * l + 1) / (4 * M_PI) * ratio);
    if (m == 0) return k * p;
    return M_SQRT2 * k * p * (m > 0 ? std::cos(order * around) : std::sin(order * around));
}

static std::array<float, kSh> at(Vec3 d) {
    Float8 y[kSh];
    evaluate(broadcast(d), y);
    std::array<float, kSh> all;
    for (size_t k = 0; k < kSh; ++k) all[k] = y[k][3];
    return all;
}

static double value(const float *f, Vec3 d) {
    double sum = 0;
    std::array<float, kSh> y = at(d);
    for (size_t k = 0; k < kSh; ++k) sum += (double)f[k] * (double)y[k];
    return sum;
}

TEST(SphericalHarmonics, AgreeWithTheRecurrence) {
    double worst = 0;
    for (Vec3 d : directions()) {
        auto y = at(d);
        for (int l = 0; l < kBands; ++l)
            for (int m = -l; m <= l; ++m)
                worst =
                    std::fmax(worst, std::fabs((double)y[(size_t)(l * (l + 1) + m)] - byRecurrence(l, m, d)));
    }
    expectAtMost("largest difference", worst, 2e-6);
}

TEST(SphericalHarmonics, AreOrthonormal) {
    double gram[kSh][kSh] = {};
    for (int i = 0; i < kDirections; i += 8) {
        Float8 y[kSh];
        float solidAngle;
        evaluate(direction(i, solidAngle), y);
        for (int a = 0; a < kSh; ++a)
            for (int b = 0; b < kSh; ++b) gram[a][b] += (double)(total(y[a] * y[b]) * solidAngle);
    }
    for (int a = 0; a < kSh; ++a)
        for (int b = 0; b < kSh; ++b) EXPECT_NEAR(gram[a][b], a == b, 2e-6) << a << ' ' << b;
}

TEST(SphericalHarmonics, KeepTheGradientAndTheGlowExactly) {
    Sky sky = {};
    sky.low = {0.9f, 0.7f, 0.5f}, sky.slope = {-0.3f, 0.1f, 0.6f}, sky.curve = {-0.2f, 0.1f, 0.3f};
    sky.least = -1;
    sky.sun = normalize(Vec3{-0.6f, 0.4f, 0.3f});
    sky.glow = {1, 0.5f, 0.25f};
    Rgb light[kSh];
    project(sky, light);
    float red[kSh], blue[kSh];
    for (int k = 0; k < kSh; ++k) red[k] = light[k].x, blue[k] = light[k].z;
    for (Vec3 d : directions()) {
        Rgb8 exact = radiance(sky, broadcast(d));
        EXPECT_NEAR(value(red, d), (double)exact.x[0], 1e-5);
        EXPECT_NEAR(value(blue, d), (double)exact.z[0], 1e-5);
    }
}

// Without a window a bright spot rings, far below zero. With a window it hardly rings, and keeps its energy.
TEST(SphericalHarmonics, AWindowEndsRinging) {
    auto least = [](float exponent, double &most) {
        auto y = at({0, 1, 0});
        double low = most = 0;
        for (int l = 0; l < kBands; ++l)
            for (int k = l * l; exponent > 0 && k < (l + 1) * (l + 1); ++k)
                y[(size_t)k] *= window(l, exponent);
        for (Vec3 d : directions()) {
            double sum = value(y.data(), d);
            low = std::fmin(low, sum), most = std::fmax(most, sum);
        }
        return low;
    };
    double most = 0, mostThrough = 0;
    double low = least(0, most), lowThrough = least(5, mostThrough);
    EXPECT_LT(low, -0.15 * most);
    EXPECT_GT(lowThrough, -0.02 * mostThrough);
    EXPECT_EQ(window(0, 16), 1);
    for (int l = 1; l < kBands; ++l) EXPECT_NEAR((double)window(l, 16), std::exp(-l * (l + 1) / 32.), 1e-6);
    EXPECT_GE(window(4, 1e-6f), 0); // the strongest window: only the mean is left
    EXPECT_NEAR(window(4, 1e6f), 1, 1e-4);
}

// Extreme skies: black, with one very bright spot, with clouds.
TEST(SphericalHarmonics, SkiesAtTheExtremes) {
    Rgb light[kSh];
    project({}, light);
    for (Rgb c : light) EXPECT_EQ(sumAbs(c), 0);
    Sky spot = plainSky({}, {});
    spot.glow = {1e-9f, 1e-9f, 1e-9f};
    spot.near = {1e6f, 1e6f, 1e6f};
    spot.sun = {0, 1, 0};
    project(spot, light);
    // The mean: 2 pi / 65 times its strength
    EXPECT_NEAR((double)light[0].x * 0.28209479, 1e6 * 2 * M_PI / 65 * 0.28209479 * 0.28209479, 20);
    for (Rgb c : light) EXPECT_TRUE(std::isfinite(c.x) && std::fabs(c.x) < 1e6f);
    // A sample's spread lowers and widens the near glow, but keeps its sum
    double sums[2] = {};
    for (int i = 0; i < 20000; ++i)
        for (int wide = 0; wide < 2; ++wide)
            sums[wide] += (double)radiance(spot, broadcast(Vec3{1, (float)i * 1e-4f - 1, 0}), kSharpClouds,
                                           broadcast(0.3f * (float)wide))
                              .x[0];
    EXPECT_NEAR(sums[1] / sums[0], 1, 0.01);
    EXPECT_LT(radiance(spot, broadcast(spot.sun), kSharpClouds, broadcast(0.3f)).x[0], 1e5f);
    Sky clouds = {{0.3f, 0.4f, 0.5f}, {}, {}, -1, {0, 1, 0}, {}, {}, {1, 1, 1}, 0.2f, 0};
    Rgb before[kSh];
    project(clouds, before);
    for (int i = 1; i <= 50; ++i) { // they move without a jump
        clouds.drift = (float)i * 0.02f;
        project(clouds, light);
        for (int k = 0; k < kSh; ++k) {
            EXPECT_LT(std::fabs(light[k].x - before[k].x), 0.02f) << i << ' ' << k;
            before[k] = light[k];
        }
    }
}
