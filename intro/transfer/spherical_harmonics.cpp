#include "transfer/spherical_harmonics.h"

#include "base/maths.h"

namespace odraz {

void evaluate(const Vec3x8 &d, Float8 *y) {
    // Compute the polynomials in the cosine of the angle to the pole, by order; then multiply by sines and
    // cosines of the angle around the pole
    Float8 z = d.y, zz = z * z;
    const Float8 along[kBands][kBands] = {
        {broadcast(0.28209479f), z * 0.48860251f, fmadd(zz, 0.94617470f, -0.31539157f),
         z * fmadd(zz, 1.86588166f, -1.11952900f),
         fmadd(fmadd(zz, 3.70249414f, -3.17356641f), zz, 0.31735664f)},
        {broadcast(-0.48860251f), z * -1.09254843f, fmadd(zz, -2.28522899f, 0.45704580f),
         z * fmadd(zz, -4.68332580f, 2.00713963f)},
        {broadcast(0.54627422f), z * 1.44530572f, fmadd(zz, 3.31161143f, -0.47308735f)},
        {broadcast(-0.59004359f), z * -1.77013077f},
        {broadcast(0.62583574f)}};
    Float8 cosine = broadcast(1.f), sine = {};
    for (int m = 0; m < kBands; ++m) {
        for (int l = m; l < kBands; ++l) {
            Float8 p = along[m][l - m];
            y[l * (l + 1) - m] = p * sine;
            y[l * (l + 1) + m] = p * cosine;
        }
        Float8 next = cosine * d.z - sine * d.x;
        sine = fmadd(cosine, d.x, sine * d.z);
        cosine = next;
    }
}

Vec3x8 direction(int first, float &solidAngle) {
    constexpr int kRings = 16, kAround = kDirections / kRings;
    static constexpr float kNode[] = {0.09501251f, 0.28160355f, 0.45801678f, 0.61787624f,
                                      0.75540441f, 0.86563120f, 0.94457502f, 0.98940093f};
    static constexpr float kWeight[] = {0.18945061f, 0.18260342f, 0.16915652f, 0.14959599f,
                                        0.12462897f, 0.09515851f, 0.06225352f, 0.02715246f};
    int ring = first / kAround, at = ring >> 1;
    Float8 around = toFloat(kLanes + first % kAround) * (2 * kPi / kAround);
    float y = ring & 1 ? -kNode[at] : kNode[at], r = sqrt(1 - y * y);
    solidAngle = kWeight[at] * (2 * kPi / kAround);
    return {r * sin(around), broadcast(y), r * cos(around)};
}

void project(const Sky &sky, Rgb *light) {
    Rgb8 sum[kSh] = {};
    for (int i = 0; i < kDirections; i += 8) {
        float solidAngle;
        Vec3x8 d = direction(i, solidAngle);
        Rgb8 from = radiance(sky, d) * broadcast(solidAngle);
        Float8 y[kSh];
        evaluate(d, y);
        for (int k = 0; k < kSh; ++k) sum[k] = fmadd(from, y[k], sum[k]);
    }
    for (int k = 0; k < kSh; ++k) light[k] = {total(sum[k].x), total(sum[k].y), total(sum[k].z)};
}

float window(int band, float exponent) {
    return exp2((float)(band * (band + 1)) * (-0.72134752f / exponent));
}

} // namespace odraz
