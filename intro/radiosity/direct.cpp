#include "radiosity/direct.h"

#include "base/maths.h"
#include "trace/rays/intersect.h"
#include "trace/shade/ball.h"

namespace odraz {

namespace {

// One sample point of each of eight texels.
struct Receivers {
    Vec3x8 p, n; // just off the surface
    Int8 active;
    int round; // 0 .. 3: the parts of a distant source that they sample
};

// A part of a light source's area, a parallelogram. The corners are clockwise as seen from the emitting side.
struct SourcePart {
    Vec3 corner[4], centre;
    int round; // the round of receivers that sample it from a distance
};

// Returns a part's form factor by Lambert's formula, a sum over the edges. Area below the receiver's horizon
// counts as negative, so the factor is too small if much of the part is there.
Float8 polygonFormFactor(Vec3x8 p, Vec3x8 n, const SourcePart &part) {
    Float8 sum = {};
    Vec3x8 a = normalize(part.corner[3] - p);
    for (Vec3 corner : part.corner) {
        Vec3x8 b = normalize(corner - p), across = cross(a, b);
        Float8 angle = acos(clamp(dot(a, b), -1.f, 1.f));
        sum = fmadd(angle, dot(across, n) / max(length(across), 1e-12f), sum);
        a = b;
    }
    return max(sum, 0.f) * (0.5f / kPi);
}
constexpr float kNear = 16; // distance^2 / area of a part: below this the disc formula is too inexact

constexpr int kWindowParts = 32, kLampParts = 16; // the most parts of a facet

// The direction to a part from eight receivers, and its visible form factor.
struct PartSample {
    Vec3x8 d;
    Float8 factor;
};

// Divides a facet into parts that are as square as possible. Returns their number.
int divideFacet(const Chart &c, const Facet &f, int most, SourcePart *parts) {
    Vec3 q = f.corner(c, 0), u = f.corner(c, 1) - q, v = f.corner(c, 3) - q;
    float ratio = length(u) / length(v);
    int across = 1;
    while (across * 2 <= most && (float)(across * across) < 0.5f * ratio * (float)most) across *= 2;
    int down = max(most / across, 1);
    u = u * (1.f / (float)across), v = v * (1.f / (float)down);
    for (int k = 0; k < across * down; ++k) {
        int i = k % across, j = k / across;
        Vec3 a = q + u * (float)i + v * (float)j;
        parts[k] = {{a, a + v, a + u + v, a + u}, a + (u + v) * 0.5f, (i + 2 * j) & 3};
    }
    return across * down;
}

struct DirectSampler {
    const Model &model;
    const Scene &scene;
    const LightBases &bases;
    int partCount;
    SourcePart parts[kWindowParts];

    // Returns the share of light that passes between the receivers and `to`. `d` gets the directions to `to`.
    Float8 visibility(const Receivers &at, Vec3x8 to, Int8 active, Vec3x8 &d) {
        to = to - at.p;
        Float8 distance = max(length(to), 1e-20f);
        d = to * (1.f / distance);
        return transmittance(scene, {at.p, d}, distance * 0.9999f, active, broadcast(-1)).y;
    }

    // Finds the directions and form factors of those parts of a facet that the receivers sample: every fourth
    // part, or all parts if the facet is near. Returns their number.
    int sampleFacet(const Receivers &at, int facet, int most, PartSample *samples) {
        const Facet &f = model.facets[facet];
        const Chart &c = model.charts[f.chart];
        Vec3x8 from = at.p - c.corner;
        Float8 height = dot(from, c.n);
        if (!any(at.active & (height > 0.f))) return 0;
        Float8 s = dot(from, c.u), t = dot(from, c.v);
        float u0 = f.u[0], u1 = f.u[2], v0 = f.v[0], v1 = f.v[2];
        partCount = divideFacet(c, f, most, parts);
        float area = (u1 - u0) * (v1 - v0) / (float)partCount;
        Float8 ds = s - clamp(s, u0, u1), dt = t - clamp(t, v0, v1);
        bool near =
            any(at.active & (fmadd(ds, ds, fmadd(dt, dt, height * height)) < area * kNear) & (height > 0.f));
        int every = near || partCount < 16 ? 1 : 4, count = 0;
        for (int k = 0; k < partCount; ++k) {
            if (every == 4 && parts[k].round != at.round) continue;
            Vec3 q = parts[k].centre;
            Vec3x8 to = q - at.p;
            Float8 square = dot(to, to), cosines = max(dot(to, at.n), 0.f) * height;
            Int8 faces = at.active & (cosines > 0.f);
            if (!any(faces)) continue;
            PartSample &part = samples[count++];
            Float8 share = visibility(at, broadcast(q), faces, part.d);
            Float8 factor =
                near ? polygonFormFactor(at.p, at.n, parts[k])
                     : cosines / square * ((float)every * area) / fmadd(square, kPi, broadcast(area));
            part.factor = select(faces, factor * share, 0.f);
        }
        return count;
    }

    // Calls `take` with each sample of an emitting chart.
    template <class Take>
    void sampleChart(const Receivers &at, int chart, int most, PartSample *samples, Take &&take) {
        const Chart &c = model.charts[chart];
        for (int f = c.firstFacet; f < c.firstFacet + c.facetCount; ++f)
            for (int i = sampleFacet(at, f, most, samples) - 1; i >= 0; --i) take(samples[i]);
    }
    void add(const Receivers &at, Float8 *sums);
};

void DirectSampler::add(const Receivers &at, Float8 *sums) {
    PartSample samples[kWindowParts];
    for (int w = 0; w < model.chartCount && bases.skyCount; ++w)
        if (model.charts[w].open)
            sampleChart(at, w, kWindowParts, samples, [&](const PartSample &s) {
                if (!any(s.factor > 0.f)) return;
                Float8 sky[kMaxSkies];
                bases.sky(bases.skies, s.d, sky);
                for (int k = 0; k < bases.skyCount; ++k) sums[k] = fmadd(sky[k], s.factor, sums[k]);
            });
    Vec3x8 d;
    for (int k = 0; k < bases.sunCount; ++k) {
        Vec3 sun = bases.suns[k];
        Int8 faces = at.active & (dot(sun - at.p, at.n) > 0.f);
        if (!any(faces)) continue;
        Float8 share = visibility(at, broadcast(sun), faces, d);
        sums[bases.firstSun() + k] += select(faces, share * dot(d, at.n), 0.f);
    }
    for (int k = 0; k < bases.lampCount; ++k) {
        const Lamp &lamp = bases.lamps[k];
        Float8 &sum = sums[bases.firstLamp() + k];
        if (lamp.radius == 0) {
            sampleChart(at, lamp.chart, kLampParts, samples, [&](const PartSample &s) { sum += s.factor; });
            continue;
        }
        // Aim at a point of the ball's disc, different for each round
        Vec3x8 to = lamp.centre - at.p;
        Float8 r = max(length(to), 1e-20f);
        Float8 factor = ballFormFactor(dot(to, at.n) / r, lamp.radius * lamp.radius / (r * r));
        Int8 lit = at.active & (factor > 0.f);
        if (!any(lit)) continue;
        Vec3x8 side = normalize(cross(to, Vec3x8{to.y, to.z, -to.x}));
        Vec3x8 up = normalize(cross(to, side));
        float x = at.round & 1 ? 0.5f : -0.5f, y = at.round & 2 ? 0.5f : -0.5f;
        Vec3x8 target = (side * broadcast(x) + up * broadcast(y)) * broadcast(lamp.radius) + lamp.centre;
        sum += select(lit, factor * visibility(at, target, lit, d), 0.f);
    }
}

} // namespace

void findDirectLight(const Model &model, const Scene &scene, const LightBases &bases, Workers &workers,
                     float *const *direct, const Progress &progress) {
    int done = 0; // texels
    parallelRanges(workers, model.texelCount, 64, [&](int first, int end, int worker) {
        DirectSampler sampler = {model, scene, bases, 0, {}};
        for (int i = first; i < end; i += 8) {
            int count = min(end - i, 8), visible[8] = {};
            Texels8 t = loadTexels(model, i, count);
            for (int k = 0; k < count; ++k) visible[k] = model.texels[i + k].visible;
            Float8 sums[kMaxBases] = {};
            Float8 pointCount = {};
            for (int round = 0; round < 4; ++round) {
                TexelPoints8 points = pointsOf(visible, round);
                if (!any(points.active)) break;
                pointCount += select(points.active, 1.f, 0.f);
                sampler.add({t.at(points.x, points.y), t.n, points.active, round}, sums);
            }
            Float8 inverse = 1.f / max(pointCount, 1.f);
            for (int k = 0; k < bases.count(); ++k) {
                Float8 sum = sums[k] * inverse;
                for (int t = 0; t < count; ++t) direct[k][i + t] = sum[t];
            }
        }
        int texels = __atomic_add_fetch(&done, end - first, __ATOMIC_RELAXED);
        if (worker == 0) progress((float)texels / (float)model.texelCount);
    });
}

} // namespace odraz
