// Spherical harmonics: against the recurrence in double precision, closed forms of rotation and windowing, and what
// a sky loses by them.
#include "transfer/spherical_harmonics.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace odraz;

namespace {

// Directions all over the sphere, poles and axes among them.
std::vector<Vec3> directions() {
    std::vector<Vec3> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    Random random = {7};
    for (int i = 0; i < 1000; ++i) {
        float y = 2 * random.next() - 1, a = 6.2831853f * random.next(), r = std::sqrt(1 - y * y);
        all.push_back({r * std::sin(a), y, r * std::cos(a)});
    }
    return all;
}

// By the recurrence of the associated Legendre functions (Press et al., "Numerical Recipes", 6.8), in double.
double byRecurrence(int l, int m, Vec3 d) {
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

std::array<float, kSh> at(Vec3 d) {
    Float8 y[kSh];
    evaluate(broadcast(d), y);
    std::array<float, kSh> all;
    for (size_t k = 0; k < kSh; ++k) all[k] = y[k][3];
    return all;
}

double value(const float *f, Vec3 d) {
    double sum = 0;
    std::array<float, kSh> y = at(d);
    for (size_t k = 0; k < kSh; ++k) sum += (double)f[k] * (double)y[k];
    return sum;
}

// The rotation by `angle` about a unit axis (Rodrigues), as rows.
Mat3 about(Vec3 k, float angle) {
    auto row = [&](Vec3 e) { // what the transposed matrix does to e
        Vec3 turned = e * std::cos(angle) - cross(k, e) * std::sin(angle) + k * (dot(k, e) * (1 - std::cos(angle)));
        return turned;
    };
    return {row({1, 0, 0}), row({0, 1, 0}), row({0, 0, 1})};
}

} // namespace

TEST(SphericalHarmonics, AreThoseOfTheRecurrence) {
    double worst = 0;
    for (Vec3 d : directions()) {
        auto y = at(d);
        for (int l = 0; l < kBands; ++l)
            for (int m = -l; m <= l; ++m)
                worst = std::fmax(worst, std::fabs((double)y[(size_t)(l * (l + 1) + m)] - byRecurrence(l, m, d)));
    }
    std::printf("largest difference %.1e\n", worst);
    EXPECT_LT(worst, 2e-6);
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

TEST(SphericalHarmonics, HoldTheGradientAndTheGlowExactly) {
    Sky sky = {{0.9f, 0.7f, 0.5f}, {-0.3f, 0.1f, 0.6f}, {-0.2f, 0.1f, 0.3f}, -1, normalize(Vec3{-0.6f, 0.4f, 0.3f}),
               {1, 0.5f, 0.25f}, {}, {}, 0, 0};
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
