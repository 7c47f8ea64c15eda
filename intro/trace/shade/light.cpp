#include "trace/shade/light.h"

#include "base/maths.h"
#include "trace/rays/beam.h"
#include "trace/shade/ball.h"
#include "trace/shade/soft_shadow.h"

namespace odraz {

namespace {

// The balls that block ambient light at a run's hits. A ball blocks at most the share radius^2 / distance^2.
// kLeast is subtracted from that share, so that the ball's effect does not begin abruptly.
constexpr float kLeast = 1 / 150.f;

struct Occluders {
    int count = 0;
    uint8_t ball[kMaxOccluders]; // indices of Scene::occluder

    // Finds the balls that block light at points in a box.
    Occluders(const Scene &scene, const Bounds &box) {
        for (int i = 0; i < scene.occluderCount; i += 8) {
            Vec3x8 c = load(scene.occluder, i);
            Float8 r = load(scene.occluderRadius + i);
            Vec3x8 outside = {max(box.lo.x - c.x, max(c.x - box.hi.x, 0.f)),
                              max(box.lo.y - c.y, max(c.y - box.hi.y, 0.f)),
                              max(box.lo.z - c.z, max(c.z - box.hi.z, 0.f))};
            int reach =
                laneBits((dot(outside, outside) * kLeast < r * r) & (kLanes < scene.occluderCount - i));
            for (; reach; reach &= reach - 1) ball[count++] = (uint8_t)(i + __builtin_ctz((unsigned)reach));
        }
    }

    // The share of ambient light that reaches points p with unit normals n.
    Float8 visibility(const Scene &scene, const Shape &shape, const Vec3x8 &p, const Vec3x8 &n) const {
        Float8 left = broadcast(1.f);
        for (int i = 0; i < count; ++i) {
            int k = ball[i];
            float r = scene.occluderRadius[k], square = r * r;
            Vec3x8 to = {scene.occluder[0][k] - p.x, scene.occluder[1][k] - p.y, scene.occluder[2][k] - p.z};
            Float8 distance2 = max(dot(to, to), 1e-12f), facing = dot(n, to);
            Int8 counts = (facing > -r) & (distance2 < square * (1 / kLeast));
            if (shape.isBall()) counts &= distance2 > square * 1.0001f; // not the point's own ball
            if (!any(counts)) continue;
            // Use the exact formula for the few balls that the horizon cuts. Most others touch a floor:
            // 0.9999 keeps rounding errors from deciding about these
            Float8 cosine = facing / sqrt(distance2), sine2 = square / distance2, blocked = cosine * sine2;
            if (any(counts & (facing * abs(facing) < square * 0.9999f)))
                blocked = ballFormFactor(cosine, sine2);
            left *= 1.f - select(counts, clamp(blocked - kLeast, 0.f, 0.95f), 0.f);
        }
        return left;
    }
};

// Finds the shapes that may be between a light and a run's hits, by the box around the hits. For few hits, or
// if the beam is too wide, found.count is -1, and shadow rays traverse the tree.
void findShadowCandidates(const Scene &scene, const Run &run, const Bounds &box, Vec3 from,
                          Candidates &found) {
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

// The sum of the light that arrives at eight hits.
struct LightSum {
    Rgb8 diffuse, highlight = {};
    Int8 states = {};
};

// Adds ambient light, from the lightmap or the scene, less what balls block.
ODRAZ_INLINE void addAmbient(const Scene &scene, const Shape &shape, const Occluders &occluders,
                             const Vec3x8 &p, const Vec3x8 &n, LightSum &sum) {
    if (shape.chart >= 0) {
        const Chart &chart = scene.lightmap->charts[shape.chart];
        sum.diffuse = lightAt(*scene.lightmap, chart, p);
        if (&chart == scene.lightmap->glossy) sum.highlight = glossAt(*scene.lightmap, p);
    } else
        sum.diffuse =
            broadcast(scene.ambientLow) + (scene.ambientHigh - scene.ambientLow) * fmadd(n.y, 0.5f, 0.5f);
    if (occluders.count) {
        Float8 visibility = occluders.visibility(scene, shape, p, n);
        sum.diffuse = sum.diffuse * visibility;
        sum.highlight = sum.highlight * visibility;
    }
}

// Phong's lobe around the mirrored rays of eight hits. On a ball the normal varies within a sample, which
// blurs highlights: the normals' variance is added to the lobe's, 1 / exponent (Kaplanyan et al., "Filtering
// Distributions of Normals", 2016).
struct Lobe {
    Vec3x8 d = {};     // directions of the rays
    Float8 dn = {};    // minus twice the cosine between ray and normal
    Float8 widen = {}; // factor on the exponent for curvature; below 1 it widens the lobe
    // Cosines: the lobe ends at `end`. Above `reach`, shadows are traced even for faint light and squares
    // split, because the highlight may lie between the corners of the coarsest squares
    Float8 end = {}, reach = broadcast(2.f);

    ODRAZ_INLINE Lobe(const Run &run, int i, const Material &m, float lobeEnd, int coarse, const Vec3x8 &n) {
        if (m.specular == 0) return;
        d = load(run.d, i);
        dn = dot(n, d) * -2.f;
        Float8 steep = load(run.curve + i) / max(load(run.cosine + i), 0.1f),
               spread = min(fmadd(steep, 2.f, load(run.spread + i)), 1.f), variance = spread * spread;
        end = fmadd(variance, -14.f, lobeEnd);
        reach = fmadd(variance, (float)(coarse * coarse) * -0.0625f, 1.f);
        widen = 1.f / fmadd(variance, m.exponent, 1.f);
    }
    // The cosine between the mirrored rays and the direction l to a light. In a ball of light, the point
    // nearest to a mirrored ray counts. `cosine` is between normal and l, `inverse` is 1 / distance.
    ODRAZ_INLINE Float8 cosineTo(const Light &light, const Vec3x8 &l, Float8 cosine, Float8 inverse) const {
        Float8 aligned = fmadd(dn, cosine, dot(d, l));
        if (light.radius > 0) {
            Float8 off = max(sqrt(max(fmadd(aligned, -2.f, 2.f), 0.f)) - inverse * light.radius, 0.f);
            aligned = fmadd(off * off, -0.5f, 1.f);
        }
        return aligned;
    }
    // The lobe's value at a cosine from cosineTo(), in active lanes.
    ODRAZ_INLINE Float8 at(Float8 aligned, const Material &m, Int8 active) const {
        Int8 near = active & (aligned > end);
        if (!any(near)) return Float8{};
        Float8 lobe = exp2(log2(clamp(aligned, 0.01f, 1.f)) * widen * m.exponent) * widen;
        return select(near, lobe * m.specular, 0.f);
    }
};

// The shapes that may be between each light and a run. They are found when the first hit needs them.
struct ShadowCasters {
    Candidates candidates[kMaxLights];
    Blockers blockers[kMaxLights];
    int found = 0; // a bit for every light

    ODRAZ_INLINE void findCasters(const Scene &scene, const Run &run, const Bounds &box, int k, bool soft) {
        if (found >> k & 1) return;
        findShadowCandidates(scene, run, box, scene.lights[k].position, candidates[k]);
        if (soft) findBlockers(scene, scene.lights[k], box, blockers[k]);
        found |= 1 << k;
    }
};

// Values that all hits of a run share.
struct RunLighting {
    const Scene &scene;
    const Run &run;
    const Material &m;
    const Bounds &box;
    float reflectance;
    float perFifth; // 5 / cutoff: converts light to fifths of the cutoff
};

// Eight hits of a run.
struct EightHits {
    int first;
    const Vec3x8 &p, &n; // p is moved off the shape by its rounding error
    Float8 side, share;  // share: the ray's weight in the picture
    Int8 active;
};

// Adds the light of one Light, less what is blocked.
ODRAZ_INLINE void addLight(const RunLighting &all, const EightHits &at, const Lobe &phong, int k,
                           ShadowCasters &casters, LightSum &sum) {
    // Skip hits that face away from the light
    const Light &light = all.scene.lights[k];
    Vec3x8 to = light.position - at.p;
    Float8 square = max(dot(to, to), 1e-8f), distance = sqrt(square), inverse = 1.f / distance;
    Vec3x8 l = to * inverse;
    Float8 cosine = dot(at.n, l), strength = inverse * inverse, lobe = {}, aligned = {};
    Int8 facing = at.active & (cosine > 0.f);
    if (!any(facing)) return;
    if (all.m.specular > 0) {
        aligned = phong.cosineTo(light, l, cosine, inverse);
        lobe = phong.at(aligned, all.m, facing);
    }
    // Below a fifth of the cutoff, add light without a shadow. From there to two fifths, shadows fade in
    Float8 unblocked =
        fmadd(cosine, all.reflectance, lobe) * (strength * at.share) * maxComponent(light.intensity);
    Int8 close = aligned > phong.reach;
    Float8 faint = select(close, 0.f, saturate(2.f - unblocked * all.perFifth));
    Int8 lit = facing & (faint < 1.f);
    Float8 tilt = l.x * light.tilt;
    Rgb8 intensity = Rgb8{1.f + tilt, fmadd(tilt * tilt, -0.55f, 1.f), 1.f - tilt} * light.intensity;
    Rgb8 bare = intensity * select(facing & ~lit, strength, 0.f);
    sum.diffuse += bare * cosine;
    sum.highlight += bare * lobe;
    if (!any(lit)) return;

    // Trace shadows. Ignore the lit shape if its outside faces the light: convex shapes do not shade
    // themselves there. In soft light, only balls inside the lamp cast shadows, not other shapes.
    // (For balls, transmittance() finds only the surface on the light's side)
    bool soft = all.scene.ballsOcclude && light.radius > 0;
    casters.findCasters(all.scene, all.run, all.box, k, soft);
    Int8 ignored = select(at.side > 0.f, unpackShape(loadInts(all.run.id + at.first)), broadcast(-1));
    Rgb8 through = transmittance(all.scene, casters.candidates[k], {at.p, l},
                                 distance - (soft ? light.radius : 0), lit, ignored, soft);
    if (soft && casters.blockers[k].count)
        through = through * softShadow(all.scene, casters.blockers[k], light, at.p, l, distance, ignored);
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
          perFifth = 5 * scene.exposure / max(c.quality.cutoff, 1e-6f);
    // Highlights end at 2^-20: powers of smaller cosines would be denormal numbers, which cost 100 cycles
    float lobeEnd = m.specular > 0 ? exp2(-20 / m.exponent) : 1;
    Bounds box = boxOf(run);
    Occluders occluders(scene, box);
    ShadowCasters casters;
    RunLighting all = {scene, run, m, box, reflectance, perFifth};

    for (int i = 0; i < run.count; i += 8) {
        Vec3x8 p = load(run.p, i), n = load(run.n, i);
        LightSum sum;
        addAmbient(scene, shape, occluders, p, n, sum);
        Float8 error = load(run.error + i), side = load(run.side + i);
        Float8 share = maxComponent(load(run.weight, i));
        Int8 active = kLanes < run.count - i;
        if (m.ior > 0) active &= side > 0.f; // inside glass, light arrives by refraction
        Lobe phong(run, i, m, lobeEnd, c.quality.coarse, n);
        p = fmadd(n, error, p);
        EightHits at = {i, p, n, side, share, active};
        for (int k = 0; k < scene.lightCount; ++k) addLight(all, at, phong, k, casters, sum);
        store(run.diffuse, i, sum.diffuse);
        store(run.highlight, i, sum.highlight);
        store(run.states + i, sum.states);
    }
}

} // namespace odraz
