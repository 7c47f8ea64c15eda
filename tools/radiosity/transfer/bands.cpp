#include "tools/radiosity/transfer/bands.h"

#include <cmath>
#include <numbers>

namespace odraz::radiosity {

namespace {

constexpr int kLast = kMostBands - 1;

// Normalisation factors of the orders of band 5, with the Condon-Shortley phase. The polynomials in
// bandFive() are derivatives of the Legendre polynomial.
struct Norms {
    float of[kLast + 1];
    Norms() {
        double ratio = 1; // (l - m)! / (l + m)!
        for (int m = 0; m <= kLast; ++m) {
            if (m > 0) ratio /= (double)((kLast + m) * (kLast - m + 1));
            double norm = std::sqrt((2 * kLast + 1) / (4 * std::numbers::pi) * ratio * (m > 0 ? 2 : 1));
            of[m] = (float)(m & 1 ? -norm : norm);
        }
    }
};

void bandFive(const Vec3x8 &d, Float8 *y) {
    static const Norms norms;
    Float8 z = d.y, zz = z * z;
    const Float8 along[kLast + 1] = {z * fmadd(fmadd(zz, 7.875f, -8.75f), zz, 1.875f),
                                     fmadd(fmadd(zz, 39.375f, -26.25f), zz, 1.875f),
                                     z * fmadd(zz, 157.5f, -52.5f),
                                     fmadd(zz, 472.5f, -52.5f),
                                     z * 945.f,
                                     broadcast(945.f)};
    Float8 cosine = broadcast(1.f), sine = {};
    for (int m = 0; m <= kLast; ++m) {
        Float8 p = along[m] * norms.of[m];
        y[kLast * (kLast + 1) - m] = p * sine;
        y[kLast * (kLast + 1) + m] = p * cosine;
        Float8 next = cosine * d.z - sine * d.x;
        sine = fmadd(cosine, d.x, sine * d.z);
        cosine = next;
    }
}

} // namespace

void evaluateBands(const Vec3x8 &d, int bands, Float8 *y) {
    static_assert(kMostBands == kBands + 1);
    evaluate(d, y);
    if (bands > kBands) bandFive(d, y);
}

int bandOf(int coefficient) { return (int)std::sqrt((double)coefficient + 0.5); }

Rgb radiance(const BandLight &light, int bands, const Vec3 &d) {
    Float8 y[kMostSh];
    evaluateBands(broadcast(d), bands, y);
    Rgb sum = {};
    for (int k = 0; k < bands * bands; ++k) sum += light[(size_t)k] * y[k][0];
    return sum;
}

Mat3 turnAbout(const Vec3 &a, double degrees) {
    double angle = degrees * std::numbers::pi / 180;
    auto c = (float)std::cos(angle), s = (float)std::sin(angle), t = 1 - c;
    return {{t * a.x * a.x + c, t * a.x * a.y - s * a.z, t * a.x * a.z + s * a.y},
            {t * a.x * a.y + s * a.z, t * a.y * a.y + c, t * a.y * a.z - s * a.x},
            {t * a.x * a.z - s * a.y, t * a.y * a.z + s * a.x, t * a.z * a.z + c}};
}

BandLight turned(const BandLight &light, int bands, const Mat3 &turn) {
    int count = bands * bands;
    Rgb8 sum[kMostSh] = {};
    for (int i = 0; i < kDirections; i += 8) {
        float solidAngle;
        Vec3x8 d = direction(i, solidAngle);
        Float8 y[kMostSh];
        evaluateBands(transposeTimes(turn, d), bands, y);
        Rgb8 radiance = {};
        for (int k = 0; k < count; ++k) radiance = fmadd(broadcast(light[(size_t)k]), y[k], radiance);
        radiance = radiance * broadcast(solidAngle);
        evaluateBands(d, bands, y);
        for (int k = 0; k < count; ++k) sum[k] = fmadd(radiance, y[k], sum[k]);
    }
    BandLight out = {};
    for (int k = 0; k < count; ++k) out[(size_t)k] = {total(sum[k].x), total(sum[k].y), total(sum[k].z)};
    return out;
}

} // namespace odraz::radiosity
