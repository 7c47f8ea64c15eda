#include "trace/shade/light.h"

#include "base/maths.h"
#include "trace/rays/beam.h"
#include "trace/shade/ball.h"
#include "trace/shade/soft_shadow.h"

namespace odraz {

namespace {

// The balls that block light from all around at a run's places. One blocks at most the share radius^2 /
// distance^2. kLeast is subtracted from what it blocks, so that its effect does not begin abruptly.
constexpr float kLeast = 1 / 150.f;

struct Occluders {
    int count = 0;
    uint8_t ball[kMaxOccluders]; // indices of Scene::occluder

    // For places in a box.
    Occluders(const Scene &scene, const Bounds &box) {
        for (int i = 0; i < scene.occluderCount; i += 8) {
            Vec3x8 c = load(scene.occluder, i);
            Float8 r = load(scene.occluderRadius + i);
            Vec3x8 off = {max(box.lo.x - c.x, max(c.x - box.hi.x, 0.f)),
                          max(box.lo.y - c.y, max(c.y - box.hi.y, 0.f)),
                          max(box.lo.z - c.z, max(c.z - box.hi.z, 0.f))};
            int reach = laneBits((dot(off, off) * kLeast < r * r) & (kLanes < scene.occluderCount - i));
            for (; reach; reach &= reach - 1) ball[count++] = (uint8_t)(i + __builtin_ctz((unsigned)reach));
        }
    }

    // The share of that light that reaches places p with unit normals n.
    Float8 open(const Scene &scene, const Shape &shape, const Vec3x8 &p, const Vec3x8 &n) const {
        Float8 left = broadcast(1.f);
        for (int i = 0; i < count; ++i) {
            int k = ball[i];
            float r = scene.occluderRadius[k], square = r * r;
            Vec3x8 to = {scene.occluder[0][k] - p.x, scene.occluder[1][k] - p.y, scene.occluder[2][k] - p.z};
            Float8 far2 = max(dot(to, to), 1e-12f), facing = dot(n, to);
            Int8 counts = (facing > -r) & (far2 < square * (1 / kLeast));
            if (shape.isBall()) counts &= far2 > square * 1.0001f; // not itself
            if (!any(counts)) continue;
            // The horizon cuts few of them. Most touch a floor: there rounding must not decide
            Float8 cosine = facing / sqrt(far2), sine2 = square / far2, taken = cosine * sine2;
            if (any(counts & (facing * abs(facing) < square * 0.9999f)))
                taken = ballFormFactor(cosine, sine2);
            left *= 1.f - select(counts, clamp(taken - kLeast, 0.f, 0.95f), 0.f);
        }
        return left;
    }
};

// Finds the shapes that may stand between a light and a run's places, by the box around these. For few
// places, or if the beam is too wide, found.count is -1, and the whole tree is tried.
void aim(const Scene &scene, const Run &run, const Bounds &box, Vec3 from, Candidates &found) {
    found.count = -1;
    if (run.count <= 16) return;
    BeamBuilder builder(from, (box.lo + box.hi) * 0.5f - from);
    Vec3x8 lo = broadcast(box.lo - from), hi = broadcast(box.hi - from);
    builder.add({select((kLanes & 1) != 0, lo.x, hi.x), select((kLanes & 2) != 0, lo.y, hi.y),
                 select((kLanes & 4) != 0, lo.z, hi.z)});
    if (builder.narrow()) findCandidates(scene, builder.beam(), found);
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

// The sum of the light that arrives at eight places.
struct Arriving {
    Rgb8 diffuse, highlight = {};
    Int8 states = {};
};

// Adds the light from all around, of the lightmap or ambient, less what balls block.
ODRAZ_INLINE void addAround(const Scene &scene, const Shape &shape, const Occluders &occluders,
                            const Vec3x8 &p, const Vec3x8 &n, Arriving &sum) {
    if (shape.chart >= 0) {
        const Chart &chart = scene.lightmap->charts[shape.chart];
        sum.diffuse = lightAt(*scene.lightmap, chart, p);
        if (&chart == scene.lightmap->glossy) sum.highlight = glossAt(*scene.lightmap, p);
    } else
        sum.diffuse =
            broadcast(scene.ambientLow) + (scene.ambientHigh - scene.ambientLow) * fmadd(n.y, 0.5f, 0.5f);
    if (occluders.count) {
        Float8 open = occluders.open(scene, shape, p, n);
        sum.diffuse = sum.diffuse * open;
        sum.highlight = sum.highlight * open;
    }
}

// Phong's lobe around the mirrored rays of eight places. On a ball the normal varies within a sample, which
// blurs highlights: the variance of the normals is added to that of the lobe, 1 / exponent (Kaplanyan et al.,
// "Filtering Distributions of Normals", 2016).
struct Lobe {
    Vec3x8 d = {}; // of the rays
    Float8 dn = {}, wider = {};
    // Cosines. At `end` the lobe ends. From `reach` on, shadows are traced even for faint light, and squares
    // split: the highlight may lie between the corners of the coarsest
    Float8 end = {}, reach = broadcast(2.f);

    ODRAZ_INLINE Lobe(const Run &run, int i, const Material &m, float lobeEnd, int coarse, const Vec3x8 &n) {
        if (m.specular == 0) return;
        d = load(run.d, i);
        dn = dot(n, d) * -2.f;
        Float8 steep = load(run.curve + i) / max(load(run.cosine + i), 0.1f),
               spread = min(fmadd(steep, 2.f, load(run.spread + i)), 1.f), variance = spread * spread;
        end = fmadd(variance, -14.f, lobeEnd);
        reach = fmadd(variance, (float)(coarse * coarse) * -0.0625f, 1.f);
        wider = 1.f / fmadd(variance, m.exponent, 1.f);
    }
    // The cosine between the mirrored rays and a light. A ball of light counts as if it stood at its point
    // nearest to them.
    ODRAZ_INLINE Float8 towards(const Light &light, const Vec3x8 &l, Float8 cosine, Float8 inverse) const {
        Float8 towards = fmadd(dn, cosine, dot(d, l));
        if (light.radius > 0) {
            Float8 off = max(sqrt(max(fmadd(towards, -2.f, 2.f), 0.f)) - inverse * light.radius, 0.f);
            towards = fmadd(off * off, -0.5f, 1.f);
        }
        return towards;
    }
    // Its value at that cosine, in active lanes.
    ODRAZ_INLINE Float8 at(Float8 towards, const Material &m, Int8 active) const {
        Int8 near = active & (towards > end);
        if (!any(near)) return Float8{};
        Float8 lobe = exp2(log2(clamp(towards, 0.01f, 1.f)) * wider * m.exponent) * wider;
        return select(near, lobe * m.specular, 0.f);
    }
};

// The shapes that may stand between each light and a run. They are found when the first place needs them.
struct InTheWay {
    Candidates among[kMaxLights];
    Blockers blockers[kMaxLights];
    int found = 0; // a bit for every light

    ODRAZ_INLINE void find(const Scene &scene, const Run &run, const Bounds &box, int k, bool soft) {
        if (found >> k & 1) return;
        aim(scene, run, box, scene.lights[k].position, among[k]);
        if (soft) findBlockers(scene, scene.lights[k], box, blockers[k]);
        found |= 1 << k;
    }
};

// What is the same for all places of a run.
struct Lit {
    const Scene &scene;
    const Run &run;
    const Material &m;
    const Bounds &box;
    float reflectance;
    float counts; // light times this is in fifths of the cutoff
};

// Eight places of a run.
struct Places {
    int first;
    const Vec3x8 &p, &n; // p is moved off the shape by its rounding error
    Float8 side, share;  // share: of the picture
    Int8 active;
};

// Adds the light of one Light, less what is blocked.
ODRAZ_INLINE void addLight(const Lit &all, const Places &at, const Lobe &phong, int k, InTheWay &way,
                           Arriving &sum) {
    // Leave out lanes that face away
    const Light &light = all.scene.lights[k];
    Vec3x8 to = light.position - at.p;
    Float8 square = max(dot(to, to), 1e-8f), far = sqrt(square), inverse = 1.f / far;
    Vec3x8 l = to * inverse;
    Float8 cosine = dot(at.n, l), strength = inverse * inverse, lobe = {}, towards = {};
    Int8 facing = at.active & (cosine > 0.f);
    if (!any(facing)) return;
    if (all.m.specular > 0) {
        towards = phong.towards(light, l, cosine, inverse);
        lobe = phong.at(towards, all.m, facing);
    }
    // Light that adds less than a fifth of the cutoff to the picture needs no shadow; from there to twice as
    // much the shadow fades in
    Float8 promised =
        fmadd(cosine, all.reflectance, lobe) * (strength * at.share) * maxComponent(light.intensity);
    Int8 close = towards > phong.reach;
    Float8 faint = select(close, 0.f, saturate(2.f - promised * all.counts));
    Int8 lit = facing & (faint < 1.f);
    Float8 tilt = l.x * light.tilt;
    Rgb8 intensity = Rgb8{1.f + tilt, fmadd(tilt * tilt, -0.55f, 1.f), 1.f - tilt} * light.intensity;
    Rgb8 bare = intensity * select(facing & ~lit, strength, 0.f);
    sum.diffuse += bare * cosine;
    sum.highlight += bare * lobe;
    if (!any(lit)) return;

    // Add the light that passes. A shape does not shade its own outside where that faces the light, and none
    // but balls within the lamp shades it. (Beams from a light know only where balls end on its side)
    bool soft = all.scene.ballsOcclude && light.radius > 0;
    way.find(all.scene, all.run, all.box, k, soft);
    Int8 own = select(at.side > 0.f, unpackShape(loadInts(all.run.id + at.first)), broadcast(-1));
    Rgb8 through =
        transmittance(all.scene, way.among[k], {at.p, l}, far - (soft ? light.radius : 0), lit, own, soft);
    if (soft && way.blockers[k].count)
        through = through * softShadow(all.scene, way.blockers[k], light, at.p, l, far, own);
    through += (Rgb{1, 1, 1} - through) * faint;
    lit &= maxComponent(through) > 0.f;
    if (!any(lit)) return;
    Rgb8 arriving = through * select(lit, strength, 0.f) * intensity;
    sum.diffuse += arriving * cosine;
    sum.highlight += arriving * lobe;
    Int8 state = select(through.x + through.y + through.z < 3.f, broadcast(3),
                        select((lobe > 0.02f) | close, broadcast(2), broadcast(1)));
    sum.states |= (lit & state) << (2 * k) | (lit & close & (int)kTextured);
}

} // namespace

void illuminate(const Shading &c, Run &run) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[run.shape];
    const Material &m = scene.materials[shape.material];
    float reflectance = maxComponent(scene.mean[shape.material]),
          counts = 5 * scene.exposure / max(c.quality.cutoff, 1e-6f);
    // Highlights end at 2^-20: powers of smaller cosines would become denormal numbers, each of which costs
    // 100 cycles
    float lobeEnd = m.specular > 0 ? exp2(-20 / m.exponent) : 1;
    Bounds box = boxOf(run);
    Occluders occluders(scene, box);
    InTheWay way;
    Lit all = {scene, run, m, box, reflectance, counts};

    for (int i = 0; i < run.count; i += 8) {
        Vec3x8 p = load(run.p, i), n = load(run.n, i);
        Arriving sum;
        addAround(scene, shape, occluders, p, n, sum);
        Float8 error = load(run.error + i), side = load(run.side + i);
        Float8 share = maxComponent(load(run.weight, i));
        Int8 active = kLanes < run.count - i;
        if (m.ior > 0) active &= side > 0.f; // inside glass, light arrives by refraction
        Lobe phong(run, i, m, lobeEnd, c.quality.coarse, n);
        p = fmadd(n, error, p);
        Places at = {i, p, n, side, share, active};
        for (int k = 0; k < scene.lightCount; ++k) addLight(all, at, phong, k, way, sum);
        store(run.diffuse, i, sum.diffuse);
        store(run.highlight, i, sum.highlight);
        store(run.states + i, sum.states);
    }
}

} // namespace odraz
