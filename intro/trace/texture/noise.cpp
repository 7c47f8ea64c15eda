#include "trace/texture/noise.h"

namespace odraz {

// Dot product of (x, y, z) with one of eight gradients: a cube's corners, turned so that none is parallel to
// the lattice. The hash's high bits select it; a look-up among eight is one instruction.
static Float8 gradient(Uint8 hash, Float8 x, Float8 y, Float8 z) {
    constexpr Float8 kX = {-0.2641f, 0.8046f, -1.3646f, -0.2958f, 0.2958f, 1.3646f, -0.8046f, 0.2641f};
    constexpr Float8 kY = {-0.6427f, 0.5723f, 0.1631f, 1.3782f, -1.3782f, -0.1631f, -0.5723f, 0.6427f};
    constexpr Float8 kZ = {-1.2317f, -1.0125f, -0.3337f, -0.1145f, 0.1145f, 0.3337f, 1.0125f, 1.2317f};
    Uint8 h = hash >> 29;
    auto pick = [&](Float8 table) { return (Float8)_mm256_permutevar8x32_ps(table, (__m256i)h); };
    return fmadd(pick(kX), x, fmadd(pick(kY), y, pick(kZ) * z));
}

static Float8 fade(Float8 t) { return t * t * t * fmadd(t, fmadd(t, 6.f, -15.f), 10.f); }

static Float8 mix(Float8 a, Float8 b, Float8 t) { return fmadd(t, b - a, a); }

Float8 noise(const Vec3x8 &p) {
    // Split into lattice cell and position within it
    Vec3x8 cell = {floor(p.x), floor(p.y), floor(p.z)};
    Vec3x8 f = p - cell;
    Uint8 x0 = (Uint8)toInt(cell.x) * 0x8da6b343u, x1 = x0 + 0x8da6b343u;
    Uint8 y0 = (Uint8)toInt(cell.y) * 0xd8163841u, y1 = y0 + 0xd8163841u;
    Uint8 z0 = (Uint8)toInt(cell.z) * 0xcb1ab31fu, z1 = z0 + 0xcb1ab31fu;
    Float8 u = fade(f.x), v = fade(f.y), w = fade(f.z);

    // Sum the eight wavelets, as trilinear interpolation along the faded coordinates
    auto corner = [](Uint8 sum, Float8 x, Float8 y, Float8 z) {
        Uint8 h = (sum ^ (sum >> 15)) * 0x2c1b3c6du;
        return gradient(h, x, y, z);
    };
    auto edge = [&](Uint8 yz, Float8 y, Float8 z) {
        return mix(corner(yz + x0, f.x, y, z), corner(yz + x1, f.x - 1.f, y, z), u);
    };
    auto face = [&](Uint8 z, Float8 fz) {
        return mix(edge(z + y0, f.y, fz), edge(z + y1, f.y - 1.f, fz), v);
    };
    Float8 sum = mix(face(z0, f.z), face(z1, f.z - 1.f), w);
    return clamp(sum, -1.f, 1.f); // where floats are coarser than cells, f may leave [0, 1]
}

Float8 bandLimit(Float8 width, float size) { return saturate(1.5f - width * (2.f / size)); }

Float8 fractalNoise(const Vec3x8 &at, int octaves, Float8 width, float finer, float weaker) {
    Vec3x8 p = at;
    Float8 sum = {};
    float amplitude = 1, size = 1;
    for (int i = 0; i < octaves; ++i) {
        Float8 strength = bandLimit(width, size);
        if (!any(strength > 0.f)) break;
        sum = fmadd(noise(p), strength * amplitude, sum);
        // The shift keeps the octaves' lattice points, where noise is zero, from coinciding
        p = p * broadcast(finer) + Vec3{17.17f, 5.31f, 11.73f};
        amplitude *= weaker;
        size /= finer;
    }
    return sum;
}

} // namespace odraz
