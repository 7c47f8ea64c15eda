#include "trace/scene/material.h"

#include "base/maths.h"
#include "trace/texture/noise.h"

namespace odraz {

// Fine bright veins where two warped noises cross zero, strong here and faint there, over slow clouds.
static Float8 marble(const Vec3x8 &p, Float8 width) {
    Float8 warp = fractalNoise(p * broadcast(0.7f), 2, width * 0.7f);
    Vec3x8 bent = p + Vec3x8{warp * 1.3f, warp * -0.9f, warp * 1.1f};
    Float8 broad = abs(noise(bent)), thin = abs(noise(bent * broadcast(2.3f) + Vec3{9.1f, 3.7f, 5.3f}));
    // A vein widens to what a sample sees, and pales in proportion
    auto vein = [](Float8 distance, Float8 halfWidth, Float8 seen) {
        Float8 wide = fmadd(seen, 0.5f, halfWidth), inside = saturate(1.f - distance / wide);
        return inside * inside * (halfWidth / wide);
    };
    Float8 strength = saturate(fmadd(warp, 0.9f, 0.55f));
    Float8 veins = fmadd(vein(broad, 0.02f + 0.1f * strength, width), strength,
                         vein(thin, broadcast(0.1f), width * 2.3f) * 0.35f);
    return saturate(fmadd(warp, 0.16f, 0.22f) + veins * 0.8f);
}

// Noise where any of it is left.
static Float8 detail(const Vec3x8 &p, Float8 strength) {
    return any(strength > 0.f) ? noise(p) * strength : Float8{};
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
    Float8 fibre = detail(along, bandLimit(width, 0.11f));
    return saturate(fmadd(fibre, 0.22f, shade * 0.75f + 0.12f));
}

// Grains of several sizes.
static Float8 stone(const Vec3x8 &p, Float8 width) {
    Float8 coarse = fractalNoise(p, 2, width);
    Float8 grain = detail(p * broadcast(11.f), bandLimit(width, 0.09f));
    return saturate(fmadd(coarse, 0.38f, fmadd(grain, 0.2f, 0.5f)));
}

static Rgb8 colour(const Texture &t, const Vec3x8 &q, Float8 width) {
    if (t.pattern == Pattern::Plain) return broadcast(t.palette[0]);
    Vec3x8 p = q * broadcast(t.scale);
    Float8 w = width * t.scale, v;
    switch (t.pattern) {
    case Pattern::Marble:
        v = marble(p, w);
        break;
    case Pattern::Wood:
        v = wood(p, w);
        break;
    case Pattern::WoodAcross:
        v = wood({p.z, p.y, p.x}, w);
        break;
    case Pattern::Cloud:
        v = fmadd(noise(p), bandLimit(w, 1.f) * 0.5f, 0.5f);
        break;
    default:
        v = stone(p, w);
        break;
    }
    // Look the number up in the palette
    Rgb8 c = broadcast(t.palette[0]);
    for (int i = 0; i < 3; ++i) c += (t.palette[i + 1] - t.palette[i]) * saturate(fmadd(v, 3.f, (float)-i));
    return c;
}

// The average of a square wave (+1 on even cells, -1 on odd ones) over [x - w/2, x + w/2].
ODRAZ_INLINE static Float8 squareWave(Float8 x, Float8 w) {
    auto integral = [](Float8 x) {
        Float8 folded = x - floor(x * 0.5f) * 2.f;
        return 1.f - abs(folded - 1.f);
    };
    w = max(w, 1e-4f);
    return clamp((integral(x + w * 0.5f) - integral(x - w * 0.5f)) / w, -1.f, 1.f);
}

Rgb8 albedo(const Material &m, const Vec3x8 &q, const Vec3x8 &d, Float8 cosine, Float8 width, Int8 &cell) {
    Float8 stretch = 1.f / max(cosine, 0.02f);
    Float8 root = sqrt(stretch), mean = width * root * sqrt(root);
    cell = Int8{};
    if (m.cell == 0) return colour(m.texture, q, mean);

    // The sample's footprint is an ellipse, long along the view: a circle across it, and its shadow along d
    Float8 x = q.x * (1.f / m.cell), z = q.z * (1.f / m.cell), narrow = width * (1.f / m.cell);
    Float8 alongX = d.x * stretch, alongZ = d.z * stretch;
    Float8 wx = narrow * sqrt(fmadd(alongX, alongX, 1.f)), wz = narrow * sqrt(fmadd(alongZ, alongZ, 1.f));
    Float8 even = fmadd(squareWave(x, wx) * squareWave(z, wz), 0.5f, 0.5f);
    Int8 sharp = max(wx, wz) < 1.f;
    cell =
        (toInt(floor(clamp(x, -1e6f, 1e6f))) * 73 + toInt(floor(clamp(z, -1e6f, 1e6f))) * 1031 + 1) & sharp;

    Rgb8 result = {};
    if (any(even > 0.f)) result = colour(m.texture, q, mean) * even;
    if (any(even < 1.f)) result += colour(m.other, q, mean) * (1.f - even);
    return result;
}

Rgb meanAlbedo(const Material &m) {
    auto mean = [](const Texture &t) {
        // How often each colour of the palette comes up, as counted
        static constexpr float kShares[][4] = {{1, 0, 0, 0},
                                               {0.26f, 0.65f, 0.08f, 0.01f},
                                               {0.25f, 0.53f, 0.21f, 0.01f},
                                               {0.25f, 0.53f, 0.21f, 0.01f},
                                               {0.02f, 0.48f, 0.48f, 0.02f},
                                               {0.02f, 0.48f, 0.48f, 0.02f}};
        Rgb sum = {};
        for (int i = 0; i < 4; ++i) sum += t.palette[i] * kShares[(int)t.pattern][i];
        return sum;
    };
    return m.cell == 0 ? mean(m.texture) : (mean(m.texture) + mean(m.other)) * 0.5f;
}

} // namespace odraz
