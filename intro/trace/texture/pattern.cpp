#include "trace/texture/pattern.h"

#include "trace/texture/noise.h"

namespace odraz {

// Fine bright veins where two warped noises cross zero, strong here and faint there, over slow clouds. They
// have an edge on one side and run out on the other.
static Float8 marble(const Vec3x8 &p, Float8 width) {
    Float8 warp = fractalNoise(p * broadcast(0.7f), 2, width * 0.7f);
    Vec3x8 bent = p + Vec3x8{warp * 1.3f, warp * -0.9f, warp * 1.1f};
    Float8 broad = noise(bent), thin = noise(bent * broadcast(2.3f) + Vec3{9.1f, 3.7f, 5.3f});
    // A vein widens to what a sample sees, and pales in proportion
    auto vein = [](Float8 off, Float8 width, Float8 seen) {
        constexpr float kEdge = 0.4f; // its share of the width
        Float8 wide = fmadd(seen, 0.5f, width), edge = fmadd(seen, 1.f, width * kEdge);
        Float8 inside = saturate(1.f - max(off / wide, -off / edge));
        return inside * inside * (width * (1 + kEdge) / (wide + edge));
    };
    Float8 strength = saturate(fmadd(warp, 0.9f, 0.55f));
    Float8 veins = fmadd(vein(broad, 0.02f + 0.1f * strength, width), strength,
                         vein(thin, broadcast(0.1f), width * 2.3f) * 0.35f);
    return saturate(fmadd(warp, 0.16f, 0.22f) + veins * 0.8f);
}

// Growth rings about the local z axis, wavering, with fibres along it.
static Float8 wood(const Vec3x8 &p, Float8 width) {
    Float8 waver = noise(p * broadcast(0.35f));
    Float8 radius = fmadd(waver, 0.55f, sqrt(fmadd(p.x, p.x, p.y * p.y)));
    Float8 ring = radius * 2.2f;
    Float8 f = ring - floor(ring);
    // Early wood darkens slowly, late wood ends abruptly
    Float8 shade = f * f * select(f > 0.88f, (1.f - f) * 8.333f, 1.f);
    shade = fmadd(shade - 0.3f, bandLimit(width * 2.2f, 1.f), 0.3f);
    Vec3x8 along = {p.x * 9.f, p.y * 9.f, p.z * 0.6f};
    Float8 fibre = fractalNoise(along, 2, width * 9.f, 3, 0.8f);
    return saturate(fmadd(fibre, 0.22f, shade * 0.75f + 0.12f));
}

// Noise of several scales about the middle of the palette.
static Float8 grains(const Vec3x8 &p, int octaves, Float8 width, float finer, float weaker) {
    return saturate(fmadd(fractalNoise(p, octaves, width, finer, weaker), 0.3f, 0.5f));
}

static Float8 valueOf(Pattern pattern, const Vec3x8 &p, Float8 width) {
    switch (pattern) {
    case Pattern::Marble:
        return marble(p, width);
    case Pattern::Wood:
        return wood(p, width);
    case Pattern::WoodAcross:
        return wood({p.z, p.y, p.x}, width);
    case Pattern::Stone:
        return grains(p, 3, width, 5, 1.1f);
    case Pattern::Plaster:
        return grains(p, 2, width, 9, 0.75f);
    case Pattern::Cloud:
        return fmadd(noise(p), bandLimit(width, 1.f) * 0.5f, 0.5f);
    case Pattern::Plain:
    case Pattern::Count:
        break;
    }
    return Float8{};
}

Rgb8 colour(const Texture &t, const Vec3x8 &q, Float8 width) {
    if (t.pattern == Pattern::Plain) return broadcast(t.palette[0]);
    Float8 v = valueOf(t.pattern, q * broadcast(t.scale), width * t.scale);
    // Look the number up in the palette
    Rgb8 c = broadcast(t.palette[0]);
    for (int i = 0; i < 3; ++i) c += (t.palette[i + 1] - t.palette[i]) * saturate(fmadd(v, 3.f, (float)-i));
    return c;
}

Rgb meanColour(const Texture &t) {
    Rgb sum = {};
    for (int i = 0; i < 4; ++i) sum += t.palette[i] * t.traits().shares[i];
    return sum;
}

} // namespace odraz
