// Vectors of three components: Vec3 of floats, Vec3x8 of eight points. Colours are Vec3 too: x, y, z are
// linear red, green and blue with sRGB's primaries.
#pragma once

#include "base/float8.h"

namespace odraz {

template <class T> struct Vec3T { T x, y, z; };
using Vec3 = Vec3T<float>;
using Vec3x8 = Vec3T<Float8>;
using Rgb = Vec3;
using Rgb8 = Vec3x8;

template <class T> ODRAZ_INLINE Vec3T<T> operator+(Vec3T<T> a, Vec3T<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> ODRAZ_INLINE Vec3T<T> operator-(Vec3T<T> a, Vec3T<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> ODRAZ_INLINE Vec3T<T> operator*(Vec3T<T> a, Vec3T<T> b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
template <class T> ODRAZ_INLINE Vec3T<T> operator*(Vec3T<T> a, T s) { return {a.x * s, a.y * s, a.z * s}; }
template <class T> ODRAZ_INLINE Vec3T<T> operator-(Vec3T<T> a) { return {-a.x, -a.y, -a.z}; }
template <class T> ODRAZ_INLINE Vec3T<T> &operator+=(Vec3T<T> &a, Vec3T<T> b) { return a = a + b; }
template <class T> ODRAZ_INLINE Vec3T<T> &operator*=(Vec3T<T> &a, Vec3T<T> b) { return a = a * b; }
template <class T> ODRAZ_INLINE Vec3T<T> operator*(T s, Vec3T<T> a) { return a * s; }

ODRAZ_INLINE Vec3x8 broadcast(Vec3 v) { return {broadcast(v.x), broadcast(v.y), broadcast(v.z)}; }
ODRAZ_INLINE Vec3x8 operator*(Vec3 a, Float8 s) { return {a.x * s, a.y * s, a.z * s}; }
ODRAZ_INLINE Vec3x8 operator*(Vec3x8 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
ODRAZ_INLINE Vec3x8 operator-(Vec3 a, Vec3x8 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
ODRAZ_INLINE Vec3x8 operator-(Vec3x8 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
ODRAZ_INLINE Vec3x8 operator+(Vec3x8 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }

template <class A, class B> ODRAZ_INLINE auto dot(Vec3T<A> a, Vec3T<B> b) {
    return fmadd(a.x, b.x, fmadd(a.y, b.y, a.z * b.z));
}
template <class T> ODRAZ_INLINE Vec3T<T> cross(Vec3T<T> a, Vec3T<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// a*s + b, fused.
template <class T> ODRAZ_INLINE Vec3T<T> fmadd(Vec3T<T> a, T s, Vec3T<T> b) {
    return {fmadd(a.x, s, b.x), fmadd(a.y, s, b.y), fmadd(a.z, s, b.z)};
}
template <class T> ODRAZ_INLINE T length(Vec3T<T> a) { return sqrt(dot(a, a)); }

// Scales a vector to unit length. Zero and vectors shorter than 1e-15 give zero, never NaN.
template <class T> ODRAZ_INLINE Vec3T<T> normalize(Vec3T<T> a) {
    T square = dot(a, a);
    return a * select(square > 1e-30f, 1.f / sqrt(max(square, 1e-30f)), T{});
}
[[gnu::noinline]] inline Vec3 normalize(const Vec3 &a) { return normalize<float>(a); } // large: one copy
ODRAZ_INLINE Vec3x8 select(Int8 m, Vec3x8 a, Vec3x8 b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
template <class T> ODRAZ_INLINE T maxComponent(Vec3T<T> a) { return max(a.x, max(a.y, a.z)); }
template <class T> ODRAZ_INLINE T sumAbs(Vec3T<T> a) { return abs(a.x) + abs(a.y) + abs(a.z); }

// Loads eight points from a structure of arrays, from index `at` on.
template <int N> ODRAZ_INLINE Vec3x8 load(const float (&values)[3][N], int at) {
    return {load(values[0] + at), load(values[1] + at), load(values[2] + at)};
}
template <int N> ODRAZ_INLINE void store(float (&values)[3][N], int at, Vec3x8 v) {
    store(values[0] + at, v.x), store(values[1] + at, v.y), store(values[2] + at, v.z);
}

// A rotation: rows are the unit axes of the local frame, so that local = M * world.
template <class T> struct Mat3T { Vec3T<T> u, v, w; };
using Mat3 = Mat3T<float>;
inline constexpr Mat3 kIdentity = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

template <class T> ODRAZ_INLINE Vec3T<T> operator*(const Mat3 &m, Vec3T<T> p) {
    return {dot(m.u, p), dot(m.v, p), dot(m.w, p)};
}
// Returns transpose(m) * p: from the local frame to the world.
template <class T> ODRAZ_INLINE Vec3T<T> transposeTimes(const Mat3 &m, Vec3T<T> p) {
    return {m.u.x * p.x + m.v.x * p.y + m.w.x * p.z, m.u.y * p.x + m.v.y * p.y + m.w.y * p.z,
            m.u.z * p.x + m.v.z * p.y + m.w.z * p.z};
}
ODRAZ_INLINE Mat3 operator*(const Mat3 &a, const Mat3 &b) {
    return {transposeTimes(b, a.u), transposeTimes(b, a.v), transposeTimes(b, a.w)};
}

} // namespace odraz
