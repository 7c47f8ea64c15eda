#include "trace/shade/light.h"

#include "base/maths.h"
#include "trace/rays/beam.h"
#include "trace/shade/ball.h"
#include "trace/shade/screen.h"

namespace odraz {

namespace {

// The balls that darken the light from all around where a run lies. One takes at most radius^2 / distance^2;
// what it takes counts from kLeast on, so that nothing begins abruptly.
constexpr float kLeast = 1 / 150.f;

struct Occluders {
    int count = 0;
    Vec3 centre[kMaxOccluders];
    float square[kMaxOccluders], radius[kMaxOccluders];

    // For places in a box.
    Occluders(const Scene &scene, const Bounds &box) {
        Vec3 a = box.lo, b = box.hi;
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

// What may stand between a light and a run's places, by their box. For few places, or around a wide beam,
// there are too many.
void aim(const Scene &scene, const Run &run, const Bounds &box, Vec3 from, Candidates &found) {
    found.count = -1;
    if (run.count <= 16) return;
    Spread spread(from, (box.lo + box.hi) * 0.5f - from);
    Vec3x8 lo = broadcast(box.lo - from), hi = broadcast(box.hi - from);
    spread.add({select((kLanes & 1) != 0, lo.x, hi.x), select((kLanes & 2) != 0, lo.y, hi.y),
                select((kLanes & 4) != 0, lo.z, hi.z)});
    if (spread.narrow()) gather(scene, spread.beam(), found);
}

Bounds boxOf(const Run &run) {
    Vec3x8 lo = load(run.p, 0), hi = lo;
    for (int i = 8; i < run.count; i += 8) {
        Vec3x8 p = load(run.p, i);
        lo = {min(lo.x, p.x), min(lo.y, p.y), min(lo.z, p.z)};
        hi = {max(hi.x, p.x), max(hi.y, p.y), max(hi.z, p.z)};
    }
    return {{least(lo.x), least(lo.y), least(lo.z)}, {-least(-hi.x), -least(-hi.y), -least(-hi.z)}};
}

} // namespace

void illuminate(const Context &c, const RayStream &in, Run &run) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[run.shape];
    const Material &m = scene.materials[shape.material];
    float reflectance = maxComponent(scene.mean[shape.material]),
          counts = 5 * scene.exposure / max(c.quality.cutoff, 1e-6f);
    // Highlights end at 2^-20: powers of smaller cosines are denormal numbers, and those cost 100 cycles each
    float lobeEnd = m.specular > 0 ? exp2(-20 / m.exponent) : 1;
    Bounds box = boxOf(run);
    Occluders occluders(scene, box);
    Candidates among[kMaxLights];
    Screens screens[kMaxLights];
    int aimed = 0; // a bit for every light

    for (int i = 0; i < run.count; i += 8) {
        // From all around: by the lightmap, or ambient
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

        // From every light. What adds less than a fifth of the cutoff to the picture needs no shadow; up to
        // twice as much, that fades in
        Float8 error = load(run.error + i), side = load(run.side + i);
        Float8 share = maxComponent(load(run.weight, i));
        Int8 states = {}, active = kLanes < run.count - i;
        if (m.ior > 0) active &= side > 0.f; // inside glass lights come by refraction
        Vec3x8 d = {};
        Float8 dn = {}, wider = {}, nearest = {}, reach = broadcast(2.f);
        if (m.specular > 0) {
            // What a sample covers of a ball blurs highlights: with variances, that of a lobe being 1 /
            // exponent, lobes and samples are added (Kaplanyan et al., "Filtering Distributions of Normals",
            // 2016)
            Eight pick(run.ray + i);
            d = pick(in.d);
            dn = dot(n, d) * -2.f;
            Float8 spread =
                       min(fmadd(load(run.curve + i) / max(load(run.cosine + i), 0.1f), 2.f, pick(in.spread)),
                           1.f),
                   variance = spread * spread;
            nearest = fmadd(variance, -14.f, lobeEnd);
            // As far as corners are apart it is looked for
            reach = fmadd(variance, -16.f, 1.f);
            wider = 1.f / fmadd(variance, m.exponent, 1.f);
        }
        p = fmadd(n, error, p);
        for (int k = 0; k < scene.lightCount; ++k) {
            // Cut lanes that face away
            const Light &light = scene.lights[k];
            Vec3x8 to = light.position - p;
            Float8 square = max(dot(to, to), 1e-8f), far = sqrt(square), inverse = 1.f / far;
            Vec3x8 l = to * inverse;
            Float8 cosine = dot(n, l), strength = inverse * inverse, lobe = {}, towards = {};
            if (m.specular > 0) {
                towards = fmadd(dn, cosine, dot(d, l));
                if (light.radius > 0) { // as if the light stood at its nearest place
                    Float8 off = max(sqrt(max(fmadd(towards, -2.f, 2.f), 0.f)) - inverse * light.radius, 0.f);
                    towards = fmadd(off * off, -0.5f, 1.f);
                }
                Int8 near = towards > nearest;
                if (any(near)) {
                    lobe = exp2(log2(clamp(towards, 0.01f, 1.f)) * wider * m.exponent) * wider;
                    lobe = select(near, lobe * m.specular, 0.f);
                }
            }
            Float8 promised =
                fmadd(cosine, reflectance, lobe) * (strength * share) * maxComponent(light.intensity);
            Int8 close = towards > reach;
            Int8 facing = active & (cosine > 0.f);
            Float8 faint = select(close, 0.f, saturate(2.f - promised * counts));
            Int8 lit = facing & (faint < 1.f);
            diffuse += light.intensity * select(facing & ~lit, strength * cosine, 0.f);
            if (!any(lit)) continue;

            // Add what comes through. A shape does not shade what faces the light on its own outside
            bool soft = scene.contact && light.radius > 0;
            if (!(aimed >> k & 1)) {
                aim(scene, run, box, light.position, among[k]);
                if (soft) findScreens(scene, light, box, screens[k]);
                aimed |= 1 << k;
            }
            Int8 own = select(side > 0.f, ((loadInts(run.id + i) - 1) >> 3), broadcast(-1));
            Rgb8 through = transmittance(scene, among[k], {p, l}, far, lit, own, soft);
            if (soft && screens[k].count)
                through = through * passScreens(scene, screens[k], light, p, l, far, own);
            through += (Rgb{1, 1, 1} - through) * faint;
            lit &= maxComponent(through) > 0.f;
            if (!any(lit)) continue;
            Rgb8 arriving = through * select(lit, strength, 0.f) * light.intensity;
            diffuse += arriving * cosine;
            highlight += arriving * lobe;
            Int8 state = select(through.x + through.y + through.z < 3.f, broadcast(3),
                                select((lobe > 0.02f) | close, broadcast(2), broadcast(1)));
            states |= (lit & state) << (2 * k);
        }
        store(run.diffuse, i, diffuse);
        store(run.highlight, i, highlight);
        store(run.states + i, states);
    }
}

} // namespace odraz
