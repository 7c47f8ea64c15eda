#include "trace/shade/secondary.h"

#include "trace/shade/contribute.h"

namespace odraz {

namespace {

// Appends rays to a stream, eight at a time, if their share of the picture is above the cutoff. Other rays
// end and add the average ambient light, or they would be darker than followed ones, and black at the
// greatest depth.
struct Emitter {
    const Shading &c;
    const RayStream &in;
    RayStream &out;
    EightRays rays;
    Int8 active;
    Rgb8 terminated = {};

    [[gnu::noinline]] void operator()(const Vec3x8 &o, const Vec3x8 &d, const Rgb8 &weight, Float8 width,
                                      Float8 spread, int branch) {
        // From the second bounce on, fade rays whose sample spreads by more than an eighth of a radian
        Float8 kept = saturate(fmadd(spread, -4.f, c.bounces ? 1.5f : 9.f));
        Int8 followed = active & (maxComponent(weight) * kept * c.scene.exposure > c.quality.cutoff);
        if (c.bounces >= c.quality.depth) followed = Int8{};
        kept = select(followed, kept, 0.f);
        const Rgb low = c.scene.ambientLow, high = c.scene.ambientHigh;
        Rgb8 light = broadcast(low) + (high - low) * fmadd(d.y, 0.5f, 0.5f);
        terminated += weight * light * select(active, 1.f - kept, 0.f);
        int lanes = laneBits(followed);
        if (!lanes) return;
        Int8 order = packedOrder(lanes);
        size_t end = (size_t)out.count; // read once: GCC must assume that the stores below may change it
        auto append = [&](auto *to, auto v) { store(to + end, permute(v, order)); };
        auto append3 = [&](float(&to)[3][kStream], Vec3x8 v) {
            append(to[0], v.x), append(to[1], v.y), append(to[2], v.z);
        };
        append3(out.o, o);
        append3(out.d, d);
        append3(out.weight, weight * kept);
        append(out.width, width);
        append(out.spread, spread);
        append(out.sample, rays(in.sample));
        append(out.path, (Int8)((Uint8)rays(in.path) * 2u + (uint32_t)branch)); // the oldest bit is lost
        out.count += __builtin_popcount((unsigned)lanes);
    }
};

// Reflects and refracts eight rays of a run.
void followEight(const Shading &c, const RayStream &in, const Run &run, RayStream &out, int i) {
    const Material &m = c.scene.materials[c.scene.shapes[run.shape].material];
    Emitter emit = {c, in, out, EightRays(run.ray + i), kLanes < run.count - i};
    Vec3x8 p = load(run.p, i), n = load(run.n, i), d = load(run.d, i);
    Rgb8 weight = load(run.weight, i);
    Float8 cosine = load(run.cosine + i), width = load(run.width + i), spread = load(run.spread + i);
    // A curved mirror widens what it reflects
    Float8 curve = load(run.curve + i), steep = 1.f / max(cosine, 0.1f),
           mirrorSpread = min(fmadd(curve * steep, 2.f, spread), 1.f);
    Vec3x8 mirrored = normalize(fmadd(n, cosine * 2.f, d));
    Vec3x8 offset = n * load(run.error + i), outside = p + offset;
    if (m.ior > 0) {
        Float8 eta = select(load(run.side + i) > 0.f, 1.f / m.ior, m.ior);
        Float8 sine2 = eta * eta * fmadd(-cosine, cosine, 1.f);
        Float8 cosineT = sqrt(max(1.f - sine2, 0.f));
        // Evaluate Fresnel's equations for both polarisations; beyond the critical angle all is reflected
        Float8 across = (eta * cosine - cosineT) / max(eta * cosine + cosineT, 1e-9f);
        Float8 along = (cosine - eta * cosineT) / max(cosine + eta * cosineT, 1e-9f);
        Float8 reflected = (across * across + along * along) * 0.5f, refracted = 1.f - reflected;
        Int8 total = sine2 >= 1.f;
        reflected = select(total, 1.f, reflected);
        refracted = select(total, 0.f, refracted);
        emit(outside, mirrored, weight * reflected, width, mirrorSpread, 2);
        Vec3x8 bent = normalize(fmadd(n, eta * cosine - cosineT, d * eta));
        // Light that leaves a ball of glass has a focus near it, so its samples start with no width
        Float8 bend = max(steep, 1.f / max(cosineT, 0.1f)) - 0.75f;
        width = select((load(run.side + i) < 0.f) & (curve > 0.f), 0.f, width);
        emit(p - offset, bent, weight * refracted, width, min(fmadd(curve, bend, spread), 1.f), 1);
    } else {
        Float8 reflected = broadcast(m.reflect);
        if (m.fresnel) {
            Float8 grazing = 1.f - cosine, square = grazing * grazing;
            reflected += (1.f - m.reflect) * square * square * grazing;
        }
        emit(outside, mirrored, weight * reflected * m.tint, width, mirrorSpread, 0);
    }
    if (any(maxComponent(emit.terminated) * c.scene.exposure > 1e-4f))
        addLight(c, in, run.ray + i, min(run.count - i, 8), emit.terminated, Int8{});
}

} // namespace

void addSecondaryRays(const Shading &c, const RayStream &in, const Run &run, RayStream &out) {
    for (int i = 0; i < run.count; i += 8) followEight(c, in, run, out, i);
}

} // namespace odraz
