// sin, cos, acos, exp2, log2 and pow without libm, for one float or for eight, bit-identical between the two.
//
//   function   range                        maximum error over all floats of that range
//   sin, cos   |x| <= 8192                  absolute 1.0e-7
//   acos       -1 <= x <= 1                 absolute 4.5e-7
//   exp2       -126 <= x <= 127.999         relative 1.5e-7; x outside is clamped to the range
//   log2       2^-126 <= x < infinity       absolute 1.2e-7 + 1.2e-7 |log2 x|; x below is taken as 2^-126
//   pow        x >= 0, |y log2 x| <= 126    relative 2.5e-7 (1 + |y log2 x|); pow(0, y) = 2^(-126 min(y,1))
//
// tests/unit/base/maths_exhaustive_test.cpp checks every row of this table against libm in double precision;
// for pow it tests the film's exponents. NaN gives a finite number or NaN, never a trap. sin and cos reduce
// their argument by the method of Cody and Waite, with pi/2 in three floats.
#pragma once

#include "base/float8.h"

namespace odraz {

inline constexpr float kPi = 3.14159265f;

// The sine of x + quadrant * pi/2.
inline Float8 sinQuadrant(Float8 x, int quadrant) {
    // Reduce to [-pi/4, pi/4]; k counts the quarter turns removed
    Float8 k = round(x * 0.636619772f);
    Float8 r = fmadd(k, -1.57079637050629f, x);
    r = fmadd(k, 4.37113882867379e-8f, r);
    r = fmadd(k, 1.71512451000588e-15f, r);
    Int8 q = toInt(k) + quadrant;
    // Evaluate both series and pick by the quadrant
    Float8 z = r * r;
    Float8 s = fmadd(fmadd(fmadd(z, -0.000195878908804f, 0.00833274827063f), z, -0.166666646623f), z * r, r);
    Float8 c = fmadd(fmadd(fmadd(z, 2.45479420851e-5f, -0.00138883030359f), z, 0.0416666646595f), z * z,
                     fmadd(z, -0.5f, broadcast(1.f)));
    Float8 y = select((q & 1) != 0, c, s);
    return fromBits(bits(y) ^ ((q & 2) << 30));
}
inline Float8 sin(Float8 x) { return sinQuadrant(x, 0); }
inline Float8 cos(Float8 x) { return sinQuadrant(x, 1); }

// Source: Abramowitz and Stegun, 4.4.46.
template <class T> T acos(T x) {
    T a = abs(x);
    T p = fmadd(fmadd(fmadd(a, -0.0012624911f, 0.0066700901f), a, -0.0170881256f), a, 0.0308918810f);
    p = fmadd(fmadd(fmadd(p, a, -0.0501743046f), a, 0.0889789874f), a, -0.2145988016f);
    p = fmadd(p, a, 1.5707963050f) * sqrt(max(1.f - a, 0.f));
    return select(x < 0.f, kPi - p, p);
}

inline Float8 exp2(Float8 x) {
    x = clamp(x, -126.f, 127.999f);
    Float8 whole = round(x);
    Float8 f = x - whole;
    Float8 p = fmadd(f, 0.000154531629451f, 0.00133908633647f);
    p = fmadd(p, f, 0.00961808255728f);
    p = fmadd(p, f, 0.0555035711422f);
    p = fmadd(p, f, 0.240226507606f);
    p = fmadd(p, f, 0.693147188026f);
    p = fmadd(p, f, 1.f);
    return fromBits(bits(p) + (toInt(whole) << 23));
}

inline Float8 log2(Float8 x) {
    x = max(x, 1.17549435e-38f);
    // Split x = m 2^e with m in [sqrt(1/2), sqrt(2))
    Int8 e = (bits(x) - 0x3f3504f3) >> 23;
    Float8 m = fromBits(bits(x) - (e << 23));
    // log2 m as an odd series in (m-1)/(m+1)
    Float8 s = (m - 1.f) / (m + 1.f);
    Float8 z = s * s;
    Float8 p = fmadd(fmadd(z, 0.431717697459f, 0.576715186019f), z, 0.961798838802f);
    p = fmadd(p, z, 2.8853900798f);
    return fmadd(p, s, toFloat(e));
}

// One float is computed as eight: a second copy of the code would cost bytes
inline float sin(float x) { return sin(broadcast(x))[0]; }
inline float cos(float x) { return cos(broadcast(x))[0]; }
inline float exp2(float x) { return exp2(broadcast(x))[0]; }
inline float log2(float x) { return log2(broadcast(x))[0]; }

template <class T> T pow(T x, float y) { return exp2(log2(x) * y); }

// 0 below a, 1 above b, with no kink at either (a < b).
template <class T> T smoothstep(float a, float b, T x) {
    T t = saturate((x - a) * (1.f / (b - a)));
    return t * t * (3.f - 2.f * t);
}

} // namespace odraz
