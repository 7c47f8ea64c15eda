#include "trace/texture/pattern.h"

#include "trace/texture/noise.h"

#include <initializer_list>

namespace odraz {

static Float8 fract(Float8 x) { return x - floor(x); }

// Fine bright veins of varying strength, where two warped noises cross zero, over slow clouds. A vein has an
// edge on one side and fades out on the other.
static Float8 marble(const Vec3x8 &p, Float8 width) {
    Float8 warp = fractalNoise(p * broadcast(0.7f), 2, width * 0.7f);
    Vec3x8 bent = p + Vec3x8{warp * 1.3f, warp * -0.9f, warp * 1.1f};
    // Add broad veins, then thin ones, which are weaker
    Float8 strength = saturate(fmadd(warp, 0.875f, 0.5625f)), weight = strength,
           vein = 0.02f + 0.1f * strength, sample = width, veins = {};
    for (int i = 0; i < 2; ++i) {
        // Widen the vein by the sample's width, and dim it in proportion
        constexpr float kEdge = 0.4f; // width of the edge, as a share of the other side's
        Float8 v = noise(bent), wide = fmadd(sample, 1.f, vein), edge = fmadd(sample, 1.5f, vein * kEdge);
        Float8 inside = saturate(1.f - max(v / wide, -v / edge));
        veins = fmadd(inside * inside, vein * (1 + kEdge) / (wide + edge) * weight, veins);
        bent = bent * broadcast(2.3f) + Vec3{9.1f, 3.7f, 5.3f};
        sample *= 2.3f, vein = broadcast(0.1f), weight = broadcast(0.35f);
    }
    return saturate(fmadd(warp, 0.15625f, 0.21875f) + veins * 0.8125f);
}

// Boards along the local z axis, one unit wide, each cut from a different trunk.
static Float8 wood(const Vec3x8 &p, Float8 width) {
    Float8 board = floor(p.x), tone = fract(board * 0.625f), x = p.x - board - 0.5f, y = p.y + tone + 0.125f;
    Float8 radius = sqrt(fmadd(x, x, y * y));
    Float8 waver = noise({radius * 1.5f, board * 7.25f, p.z * 0.375f});
    constexpr float kRings = 16;
    Float8 ring = fmadd(waver, 5.f, radius * kRings), year = floor(ring), f = ring - year;
    // Early wood darkens slowly, late wood ends abruptly; rings differ in strength
    Float8 perRing = width * kRings;
    Float8 shade = min(f * f * fmadd(fract(year * 0.625f), 0.625f, 0.5f), (1.f - f) / max(perRing, 0.0625f));
    shade = fmadd(shade - 0.25f, bandLimit(perRing, 2.f), 0.25f);
    // Pores: short dark streaks, most of them in early wood
    Float8 pores = bandLimit(width * 64.f, 1.f);
    if (any(pores > 0.f)) pores *= max(noise(p * Vec3{64, 64, 2.5f}) - f * 0.375f, 0.f) - 0.04f;
    return saturate(fmadd(tone, 0.25f, fmadd(shade, 0.75f, 0.0625f + pores)));
}

// Granite: crystals are the cells of scattered points (Worley, "A Cellular Texture Basis Function", 1996);
// pale ones are larger. The points are close to a skewed lattice, so that the nearest one belongs to one of
// the four corners of a simplex (Perlin, "Noise Hardware", 2001). The hash's factors are multiples of 1/1024,
// so that its sum is exact with and without fused products. Samples as wide as a crystal have the mean.
static Float8 stone(const Vec3x8 &at, Float8 width) {
    Float8 skew = (at.x + at.y + at.z) * (1 / 3.f);
    Vec3x8 p = at + Vec3x8{skew, skew, skew};
    // Fold space, which makes edges crooked and tones uneven
    Float8 crisp = bandLimit(width, 0.5f), uneven = {};
    for (float size = 1.125f; size > 0.4f; size *= 0.4375f) {
        Float8 most = crisp * (size * 0.4375f);
        auto fold = [&](Float8 x, Float8 y) {
            x = fmadd(x, 0.7f, y) * (1 / size);
            return abs(x - round(x)) * most;
        };
        Vec3x8 by = {fold(p.y, p.z), fold(p.z, p.x), fold(p.x, p.y)};
        p += by, uneven = by.x + by.y - most * 0.5f;
    }
    Vec3x8 low = {floor(p.x), floor(p.y), floor(p.z)}, f = p - low;
    constexpr Vec3 kHash = {7.3095703125f, 5.1708984375f, 3.7705078125f};
    Float8 nearest = broadcast(9.f), tone = {}, perEdge = 1.f / fmadd(width, 1.5f, 0.03125f);
    // Visit the simplex's corners: step along the axis of the largest coordinate first, of the least last
    Float8 more = max(f.x, f.y), less = min(f.x, f.y);
    for (Float8 from : {broadcast(2.f), max(more, f.z), max(less, min(more, f.z)), Float8{}}) {
        auto step = [&](Float8 x) { return select(x >= from, 1.f, 0.f); };
        Vec3x8 next = {step(f.x), step(f.y), step(f.z)};
        Float8 n = dot(low + next, broadcast(kHash)), random = fract(n * fract(n));
        auto jitter = [](Float8 share) { return fmadd(share, 0.3f, -0.15f); };
        Vec3x8 to =
            next - f + Vec3x8{jitter(random), jitter(fract(random * 59.f)), jitter(fract(random * 211.f))};
        // The squared distance in unskewed space, less a bonus for pale crystals
        Float8 sum = to.x + to.y + to.z, distance = fmadd(sum * -0.25f, sum, dot(to, to)) - random * 0.21875f;
        tone = fmadd(random - tone, saturate(fmadd(nearest - distance, perEdge, 0.5f)), tone);
        nearest = min(nearest, distance);
    }
    tone = fmadd(tone - 0.56f, bandLimit(width, 2.5f), 0.56f);
    return saturate(fmadd(uneven, 0.4f, tone));
}

// Plaster, stained in patches and near the floor, and streaked by the trowel.
static Float8 plaster(const Vec3x8 &p, Float8 width) {
    Float8 patches = noise(p), bent = patches * 2.f;
    Float8 streaks = fractalNoise(p * Vec3{3, 5, 3} + Vec3x8{bent, bent, bent}, 3, width * 5.f, 3, 0.6f);
    return saturate(fmadd(streaks * 0.5f + patches + saturate(1.f - abs(p.y)), 0.3125f, 0.4375f));
}

// Tubes along z, one unit apart: 0 on a tube's axis, rising to 1 at its edge, 0.35 units from the axis.
static Float8 tubes(const Vec3x8 &p, Float8 width) {
    Float8 offset = fract(p.x) - 0.5f;
    return fmadd(min(offset * offset * 8.f, 1.f) - 0.4f, bandLimit(width, 2.f), 0.4f);
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
        return stone(p, width);
    case Pattern::Plaster:
        return plaster(p, width);
    case Pattern::Tubes:
        return tubes(p, width);
    case Pattern::Plain:
    case Pattern::Count:
        break;
    }
    return Float8{};
}

Rgb8 colour(const Texture &t, const Vec3x8 &q, Float8 width) {
    if (t.pattern == Pattern::Plain) return broadcast(t.palette[0]);
    // Interpolate in the palette, whose colours are three floats apart
    Float8 v = valueOf(t.pattern, q * broadcast(t.scale), width * t.scale) * 3.f, from = min(floor(v), 2.f);
    auto at = [&](int first, Int8 i) {
        return (Float8)_mm256_permutevar8x32_ps(load(&t.palette[0].x + first), (__m256i)i);
    };
    Int8 i = toInt(from * 3.f);
    auto channel = [&](int k) {
        Float8 a = at(k, i);
        return fmadd(at(k + 2, i + 1) - a, v - from, a);
    };
    return {channel(0), channel(1), channel(2)};
}

Rgb meanColour(const Texture &t) {
    Rgb sum = {};
    for (int i = 0; i < 4; ++i) sum += t.palette[i] * t.traits().shares[i];
    return sum;
}

} // namespace odraz
