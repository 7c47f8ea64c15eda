#include "trace/shade/contribute.h"

#include "base/random.h"
#include "trace/shade/diffuse.h"
#include "trace/shade/sunshafts.h"

namespace odraz {

namespace {

// Transposes four registers of eight floats to eight rows of four.
struct EightRows {
    __m128 row[8];
    EightRows(Vec3x8 v, Int8 w) {
        __m256 xy = _mm256_unpacklo_ps(v.x, v.y), xyHigh = _mm256_unpackhi_ps(v.x, v.y);
        __m256 zw = _mm256_unpacklo_ps(v.z, (Float8)w), zwHigh = _mm256_unpackhi_ps(v.z, (Float8)w);
        auto put = [&](int i, __m256 four) {
            row[i] = _mm256_castps256_ps128(four);
            row[i + 4] = _mm256_extractf128_ps(four, 1);
        };
        put(0, _mm256_shuffle_ps(xy, zw, 0x44));
        put(1, _mm256_shuffle_ps(xy, zw, 0xee));
        put(2, _mm256_shuffle_ps(xyHigh, zwHigh, 0x44));
        put(3, _mm256_shuffle_ps(xyHigh, zwHigh, 0xee));
    }
};

} // namespace

void addLight(const Shading &c, const RayStream &in, const int32_t *ray, int count, const Rgb8 &light,
              Int8 marks) {
    EightRows rows(light, marks);
    for (int k = 0; k < count; ++k) {
        float *rest = c.samples.restOf(in.sample[ray[k]]);
        __m128 was = _mm_load_ps(rest), more = rows.row[k], none = _mm_setzero_ps();
        __m128i sumOfMarks = _mm_add_epi32(_mm_castps_si128(was), _mm_castps_si128(more));
        __m128 sum = _mm_blend_ps(was, none, 8) + _mm_blend_ps(more, none, 8);
        _mm_store_ps(rest, _mm_blend_ps(sum, _mm_castsi128_ps(sumOfMarks), 8));
    }
}

namespace {

// The samples of eight primary rays. Their radiance is albedo * light + rest.
struct EightSamples {
    Rgb8 albedo;
    Int8 id;
    Rgb8 light;
    Int8 states; // the lights' states
    Rgb8 rest;
};

// Initialises the samples of eight primary rays.
void begin(const Shading &c, const RayStream &in, const int32_t *ray, int count, const EightSamples &seen) {
    Rgb8 added = c.samples.whole ? seen.rest : seen.rest + seen.albedo * seen.light;
    EightRows third(added, Int8{});
    if (!c.samples.whole) {
        for (int k = 0; k < count; ++k) _mm_store_ps(c.samples.restOf(in.sample[ray[k]]), third.row[k]);
        return;
    }
    EightRows first(seen.albedo, seen.id), second(seen.light, seen.states);
    for (int k = 0; k < count; ++k) {
        Sample &s = c.samples.whole[in.sample[ray[k]]];
        _mm_store_ps(&s.albedo.x, first.row[k]);
        _mm_store_ps(&s.light.x, second.row[k]);
        _mm_store_ps(&s.rest.x, third.row[k]);
    }
}

// Clouds have less detail in mirrors and glass: balls show them so small that they would look like spotted
// fur, and coarse squares would miss them.
constexpr float kSoftClouds = 0.175f;

Int8 hash(Int8 x) { return (Int8)pcg((Uint8)x) & ~kLamps; }

// The light of sunshafts between the eye and the hits.
Rgb8 sunshaftLight(const Shading &c, const RayStream &in, const EightRays &rays, const Vec3x8 &d) {
    if (c.scene.shafts.openings == 0) return Rgb8{};
    return shaftLight(c.scene.shafts, rays(in.o), d, rays(in.t));
}

float contrastOf(const Shading &c, const Material &m) { return m.faint() ? c.quality.faint : 1; }

// The light that eight hits of a run emit. In reflections balls that only glow are skipped, because
// addGlowingBalls() adds them. Other lamps fade in second reflections, and in glass that mirrors them, where
// they are narrower than the distance between samples: they would flicker. Faded, they are about as bright as
// their surroundings.
Rgb8 emitted(const Shading &c, const Run &run, int i, const EightRays &rays, const RayStream &in) {
    const Shape &shape = c.scene.shapes[run.shape];
    const Material &m = c.scene.materials[shape.material];
    Rgb8 light = load(run.weight, i) * m.emit;
    if (c.bounces == 0) return light * m.tint; // a lamp's tint dims it only where it is seen directly
    if (shape.isBall() && m.onlyGlows()) return Rgb8{};
    if (!shape.traits().bounded || !(maxComponent(m.emit) > 0)) return light;
    return light *
           select(rays(in.path) < (m.onlyGlows() ? kTwoBounces : 0), 1.f,
                  clamp(min(shape.half.x, shape.half.z) * 2 / load(run.width + i) - 1.f, 0.005f, 1.f));
}

// What eight hits of a run send along their rays. `cell`: the cells of their patterns.
EightSamples samplesOf(const Shading &c, const RayStream &in, const Run &run, int i, const EightRays &rays,
                       const Vec3x8 &d, Int8 &cell) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[run.shape];
    const Material &m = scene.materials[shape.material];
    Rgb8 albedo = {}, light = {}, rest = emitted(c, run, i, rays, in);
    if (!m.plain()) light = rest, rest = Rgb8{}; // the pattern multiplies a lamp's own light
    Int8 states = {};
    float contrast = contrastOf(c, m);
    if (m.diffuse > 0 || m.specular > 0) {
        rest += load(run.weight, i) * load(run.highlight, i);
        light += load(run.weight, i) * load(run.diffuse, i);
        states = loadInts(run.states + i);
        if (m.diffuse > 0 && (contrast > 0 || scene.lines != 0))
            albedo = diffuseColour(scene, shape, load(run.p, i), d, load(run.cosine + i), load(run.width + i),
                                   cell);
        if (contrast < 1 && scene.lines == 0)
            albedo = lerp(broadcast(scene.mean[shape.material]), albedo, broadcast(contrast));
    }
    if (scene.fog > 0) rest += radiance(scene.sky, d) * rays(in.weight) * (1.f - load(run.clear + i));
    return {albedo, loadInts(run.id + i), light, states, rest};
}

// Adds the light of eight hits after a bounce, and changes a sample's mark if its hit has enough weight. The
// mark also depends on the ray's path.
void addMarked(const Shading &c, const RayStream &in, const Run &run, int i, const EightRays &rays, int count,
               const EightSamples &seen, Int8 cell) {
    const Material &m = c.scene.materials[c.scene.shapes[run.shape].material];
    Rgb8 weight = load(run.weight, i), sent = seen.rest + seen.albedo * seen.light;
    if (m.onlyGlows()) weight += seen.rest; // a lamp shows in weak mirrors, too
    Int8 marked = maxComponent(weight) * c.scene.exposure > c.quality.markWeight;
    Int8 mark = marked & hash(rays(in.path) ^ hash(seen.id ^ hash(cell ^ seen.states << 16)));
    addLight(c, in, run.ray + i, count, sent, mark);
    if (m.diffuse == 0 || m.texture.pattern == Pattern::Plain || maxComponent(m.emit) > 0 ||
        contrastOf(c, m) < 1)
        return;
    // Ignore dark textures, unless they mirror and so may show a light
    if (m.reflect == 0) marked &= maxComponent(sent) * c.scene.exposure > c.quality.markWeight * 0.3f;
    for (int lanes = laneBits(marked) & ((1 << count) - 1); lanes; lanes &= lanes - 1)
        c.samples.whole[in.sample[run.ray[i + __builtin_ctz((unsigned)lanes)]]].lights |= kTextured;
}

// Adds the light that eight hits of a run send along their rays.
void addEight(const Shading &c, const RayStream &in, const Run &run, int i) {
    EightRays rays(run.ray + i);
    int count = min(run.count - i, 8);
    Vec3x8 d = load(run.d, i);
    Int8 cell = {};
    EightSamples seen = samplesOf(c, in, run, i, rays, d, cell);
    if (c.bounces == 0) {
        if (c.scene.lines != 0)
            seen.states += cell << kCellShift; // so that squares split at patches' borders
        seen.rest += sunshaftLight(c, in, rays, d);
        begin(c, in, run.ray + i, count, seen);
    } else if (c.samples.whole)
        addMarked(c, in, run, i, rays, count, seen, cell);
    else
        addLight(c, in, run.ray + i, count, seen.rest + seen.albedo * seen.light, Int8{});
}

} // namespace

void addSurfaces(const Shading &c, const RayStream &in, const Run &run) {
    for (int i = 0; i < run.count; i += 8) addEight(c, in, run, i);
}

void addSky(const Shading &c, const RayStream &in, const Run &run) {
    for (int i = 0; i < run.count; i += 8) {
        EightRays rays(run.ray + i);
        Vec3x8 d = rays(in.d);
        Rgb8 weight = rays(in.weight),
             light =
                 radiance(c.scene.sky, d, c.bounces ? kSoftClouds : kSharpClouds, rays(in.spread)) * weight;
        int count = min(run.count - i, 8);
        if (c.bounces == 0)
            begin(c, in, run.ray + i, count,
                  {Rgb8{}, Int8{}, Rgb8{}, Int8{}, light + sunshaftLight(c, in, rays, d)});
        else
            addLight(c, in, run.ray + i, count, light,
                     hash(rays(in.path)) & (weight.y > c.quality.markWeight));
    }
}

} // namespace odraz
