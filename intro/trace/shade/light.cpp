#include "trace/shade/light.h"

#include "base/maths.h"
#include "trace/rays/beam.h"
#include "trace/shade/ball.h"

namespace odraz {

namespace {

// The balls that darken the light from all around where a run lies. One takes at most radius^2 / distance^2;
// what it takes counts from kLeast on, so that nothing begins abruptly.
constexpr float kLeast = 1 / 150.f;

struct Occluders {
    int count = 0;
    Vec3 centre[kMaxOccluders];
    float square[kMaxOccluders], radius[kMaxOccluders];

    Occluders(const Scene &scene, const Run &run) {
        if (!scene.occluderCount) return;
        Vec3x8 lo = load(run.p, 0), hi = lo;
        for (int i = 8; i < run.count; i += 8) {
            Vec3x8 p = load(run.p, i);
            lo = {min(lo.x, p.x), min(lo.y, p.y), min(lo.z, p.z)};
            hi = {max(hi.x, p.x), max(hi.y, p.y), max(hi.z, p.z)};
        }
        Vec3 a = {least(lo.x), least(lo.y), least(lo.z)}, b = {-least(-hi.x), -least(-hi.y), -least(-hi.z)};
        for (int i = 0; i < scene.occluderCount; ++i) {
            Vec3 c = scene.occluder[i];
            Vec3 off = c - Vec3{clamp(c.x, a.x, b.x), clamp(c.y, a.y, b.y), clamp(c.z, a.z, b.z)};
            float r = scene.occluderRadius[i];
            if (dot(off, off) * kLeast >= r * r) continue;
            centre[count] = c;
            square[count] = r * r;
            radius[count++] = r;
        }
    }

    // What of that light is left.
    Float8 open(const Shape &shape, const Vec3x8 &p, const Vec3x8 &n) const {
        Float8 left = broadcast(1.f);
        for (int i = 0; i < count; ++i) {
            Vec3x8 to = centre[i] - p;
            Float8 far2 = max(dot(to, to), 1e-12f), facing = dot(n, to);
            Int8 counts = (facing > -radius[i]) & (far2 * kLeast < square[i]);
            if (shape.kind == ShapeKind::Sphere) counts &= far2 > square[i] * 1.0001f; // not itself
            if (!any(counts)) continue;
            Float8 taken = ballFormFactor(facing / sqrt(far2), square[i] / far2) - kLeast;
            left *= 1.f - select(counts, clamp(taken, 0.f, 0.95f), 0.f);
        }
        return left;
    }
};

// What may stand between a light and a run's places. For few places, or around a wide beam, there are too
// many.
void aim(const Scene &scene, const Run &run, Vec3 from, Candidates &found) {
    found.count = -1;
    if (run.count <= 8) return;
    Spread spread(from, Vec3{run.p[0][0], run.p[1][0], run.p[2][0]} - from);
    for (int i = 0; i < run.count; i += 8) spread.add(load(run.p, i) - from);
    if (spread.narrow()) gather(scene, spread.beam(), found);
}

} // namespace

void illuminate(const Context &c, const RayStream &in, Run &run) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[run.shape];
    const Material &m = scene.materials[shape.material];
    float reflectance = maxComponent(scene.mean[shape.material]),
          least = c.quality.cutoff * 0.05f / scene.exposure;

    // From all around: by the lightmap, or ambient
    Occluders occluders(scene, run);
    for (int i = 0; i < run.count; i += 8) {
        Vec3x8 p = load(run.p, i), n = load(run.n, i);
        Rgb8 diffuse, highlight = {};
        if (shape.chart >= 0) {
            const Chart &chart = scene.lightmap->charts[shape.chart];
            diffuse = lightAt(*scene.lightmap, chart, p);
            if (&chart == scene.lightmap->glossy) highlight = glossAt(*scene.lightmap, p);
        } else
            diffuse =
                broadcast(scene.ambientLow) + (scene.ambientHigh - scene.ambientLow) * fmadd(n.y, 0.5f, 0.5f);
        if (occluders.count) {
            Float8 open = occluders.open(shape, p, n);
            diffuse = diffuse * open;
            highlight = highlight * open;
        }
        store(run.diffuse, i, diffuse);
        store(run.highlight, i, highlight);
        store(run.states + i, Int8{});
    }

    // From every light. What would add less than a twentieth of the cutoff to the picture is left out
    float lobeEnd = m.specular > 0 ? exp2(-20 / m.exponent) : 1;
    for (int k = 0; k < scene.lightCount; ++k) {
        const Light &light = scene.lights[k];
        Candidates among;
        bool aimed = false;
        for (int i = 0; i < run.count; i += 8) {
            // Cut lanes that face away
            Vec3x8 n = load(run.n, i), p = fmadd(n, load(run.error + i), load(run.p, i));
            Vec3x8 to = light.position - p;
            Float8 square = max(dot(to, to), 1e-8f), far = sqrt(square), inverse = 1.f / far;
            Vec3x8 l = to * inverse;
            Float8 cosine = dot(n, l), strength = inverse * inverse;
            // Highlights end at 2^-20: powers of smaller cosines are denormal numbers, and those cost 100
            // cycles each. What a sample covers of a ball blurs them: with variances, that of a lobe being
            // 1 / exponent, lobes and samples are added (Kaplanyan et al., "Filtering Distributions of
            // Normals", 2016)
            Float8 lobe = {};
            if (m.specular > 0) {
                Eight pick(run.ray + i);
                Vec3x8 d = pick(in.d);
                Float8 towards = fmadd(dot(n, d) * -2.f, cosine, dot(d, l));
                Float8 spread = min(fmadd(load(run.curve + i), 2.f, pick(in.spread)), 1.f),
                       variance = spread * spread * (1 / 3.f);
                Int8 near = towards > fmadd(variance, -14.f, lobeEnd);
                if (any(near)) {
                    Float8 wider = 1.f / fmadd(variance, m.exponent, 1.f);
                    lobe = exp2(log2(clamp(towards, 0.01f, 1.f)) * wider * m.exponent) * wider;
                    lobe = select(near, lobe * m.specular, 0.f);
                }
            }
            Float8 share = maxComponent(load(run.weight, i));
            Float8 promised =
                fmadd(cosine, reflectance, lobe) * (strength * share) * maxComponent(light.intensity);
            Int8 lit = (kLanes < run.count - i) & (cosine > 0.f) & (promised > least);
            Float8 side = load(run.side + i);
            if (m.ior > 0) lit &= side > 0.f; // inside glass lights come by refraction
            if (!any(lit)) continue;

            // Add what comes through. A shape does not shade what faces the light on its own outside
            if (!aimed) aim(scene, run, light.position, among);
            aimed = true;
            Int8 own = select(side > 0.f, ((loadInts(run.id + i) - 1) >> 3), broadcast(-1));
            Rgb8 through = transmittance(scene, among, {p, l}, far, lit, own);
            lit &= maxComponent(through) > 0.f;
            if (!any(lit)) continue;
            Rgb8 arriving = through * select(lit, strength, 0.f) * light.intensity;
            store(run.diffuse, i, load(run.diffuse, i) + arriving * cosine);
            store(run.highlight, i, load(run.highlight, i) + arriving * lobe);
            Int8 state = select(through.x + through.y + through.z < 3.f, broadcast(3),
                                select(lobe > 0.02f, broadcast(2), broadcast(1)));
            store(run.states + i, loadInts(run.states + i) | (lit & state) << (2 * k));
        }
    }
}

} // namespace odraz
