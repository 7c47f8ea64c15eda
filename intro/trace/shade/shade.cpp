// What becomes of rays where they arrive: the sky, or a run of hits.
#include "base/maths.h"
#include "base/random.h"
#include "trace/shade/whitted.h"

namespace odraz {

namespace {

// Rows of four from four times eight.
struct Rows {
    __m128 row[8];
    Rows(Vec3x8 v, Int8 w) {
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

// Adds light and marks to the samples of eight rays.
void addRest(const Context &c, const RayStream &in, const int32_t *ray, int count, const Rgb8 &light,
             Int8 marks) {
    Rows rows(light, marks);
    for (int k = 0; k < count; ++k) {
        float *rest = &c.samples[in.sample[ray[k]]].rest.x;
        __m128 was = _mm_load_ps(rest), more = rows.row[k], none = _mm_setzero_ps();
        __m128i marks = _mm_add_epi32(_mm_castps_si128(was), _mm_castps_si128(more));
        __m128 sum = _mm_blend_ps(was, none, 8) + _mm_blend_ps(more, none, 8);
        _mm_store_ps(rest, _mm_blend_ps(sum, _mm_castsi128_ps(marks), 8));
    }
}

// Begins the samples of eight primary rays.
void begin(const Context &c, const RayStream &in, const int32_t *ray, int count, const Rgb8 &albedo, Int8 id,
           const Rgb8 &light, Int8 lights, const Rgb8 &rest) {
    Rows first(albedo, id), second(light, lights), third(rest, Int8{});
    for (int k = 0; k < count; ++k) {
        Sample &s = c.samples[in.sample[ray[k]]];
        _mm_store_ps(&s.albedo.x, first.row[k]);
        _mm_store_ps(&s.light.x, second.row[k]);
        _mm_store_ps(&s.rest.x, third.row[k]);
    }
}

Int8 hash(Int8 x) { return (Int8)pcg((Uint8)x); }

// A point in the shape's own frame, where its texture lies; a rectangle's lies in the world's.
Vec3x8 localOf(const Shape &s, Vec3x8 p) {
    if (s.traits().joins) return p;
    Vec3x8 q = p - s.centre;
    return s.aligned ? q : s.frame * q;
}

// The diffuse colour of a place. In a scene that shows its patches it has the lines between them, and `cell`
// tells the patches apart.
Rgb8 diffuseColour(const Scene &scene, const Shape &shape, const Vec3x8 &p, const Vec3x8 &d, Float8 cosine,
                   Float8 width, Int8 &cell) {
    const Material &m = scene.materials[shape.material];
    cell = Int8{};
    Rgb8 colour;
    if (m.plain()) {
        colour = broadcast(m.texture.palette[0] * m.diffuse);
    } else {
        Vec3x8 local = shape.traits().joins || shape.aligned ? d : shape.frame * d;
        colour = albedo(m, localOf(shape, p) + shape.textureShift, local, cosine, width, cell) *
                 broadcast(m.diffuse);
    }
    if (scene.lines > 0 && shape.chart >= 0) {
        Float8 clear;
        cell = patchAt(scene.lightmap->charts[shape.chart], p, width / sqrt(max(cosine, 0.02f)), clear);
        colour = colour * fmadd(clear - 1.f, scene.lines, 1.f);
    }
    return colour;
}

// Where eight rays of a run arrive, and what is left of them there.
void arrive(const Context &c, const RayStream &in, Run &run, int i) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[run.shape];
    const Material &m = scene.materials[shape.material];
    Eight pick(run.ray + i);
    Ray8 ray = {pick(in.o), pick(in.d)};
    Float8 t = pick(in.t);
    Vec3x8 p, n;
    Int8 id;
    Float8 size;
    if (run.balls) {
        // Each lane has a ball of its own
        Int8 index = pick(in.shape);
        int32_t at[8];
        store(at, index);
        Vec3x8 centre;
        Float8 radius;
        for (int k = 0; k < 8; ++k) {
            const Shape &s = scene.shapes[at[k]];
            centre.x[k] = s.centre.x, centre.y[k] = s.centre.y, centre.z[k] = s.centre.z;
            radius[k] = s.half.x;
        }
        n = normalize(fmadd(ray.d, t, ray.o - centre));
        p = fmadd(n, radius, centre);
        size = sumAbs(centre) + radius;
        id = index * 8 + 1;
    } else {
        Surface8 at = surfaceAt(shape, ray, t);
        p = at.p, n = at.n;
        size = broadcast(magnitude(shape));
        id = at.face + (run.shape * 8 + 1);
    }
    // Turn the normal to the side that the ray came from
    Float8 side = select(dot(n, ray.d) > 0.f, -1.f, 1.f);
    n = n * side;
    store(run.p, i, p);
    store(run.n, i, n);
    store(run.side + i, side);
    store(run.error + i, errorBound(p, size));
    store(run.cosine + i, clamp(-dot(n, ray.d), 0.f, 1.f));
    store(run.width + i, fmadd(pick(in.spread), t, pick(in.width)));
    store(run.id + i, id);

    // Weaken by what was passed: fog on the way, glass if the ray comes from inside
    Rgb8 weight = pick(in.weight);
    if (scene.fog > 0) {
        Float8 clear = exp2(t * -scene.fog);
        store(run.clear + i, clear);
        weight = weight * clear;
    }
    if (m.ior > 0 && maxComponent(m.absorb) > 0) {
        auto through = [&](float absorb) { return select(side < 0.f, exp2(t * -absorb), 1.f); };
        weight = weight * Rgb8{through(m.absorb.x), through(m.absorb.y), through(m.absorb.z)};
    }
    store(run.weight, i, weight);
}

// Adds what eight places of a run show to their samples.
void addShown(const Context &c, const RayStream &in, const Run &run, int i) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[run.shape];
    const Material &m = scene.materials[shape.material];
    Eight pick(run.ray + i);
    int count = min(run.count - i, 8);
    Rgb8 weight = load(run.weight, i), albedo = {}, light = {}, rest = weight * m.emit;
    Int8 cell = {}, states = {};
    if (m.diffuse > 0 || m.specular > 0) {
        rest += weight * load(run.highlight, i);
        light = weight * load(run.diffuse, i);
        states = loadInts(run.states + i);
        if (m.diffuse > 0)
            albedo = diffuseColour(scene, shape, load(run.p, i), pick(in.d), load(run.cosine + i),
                                   load(run.width + i), cell);
    }
    if (scene.fog > 0)
        rest += radiance(scene.sky, pick(in.d)) * pick(in.weight) * (1.f - load(run.clear + i));
    Int8 id = loadInts(run.id + i);
    if (c.bounces == 0) {
        if (scene.lines > 0) states += cell << 16; // a mosaic: patches end abruptly
        begin(c, in, run.ray + i, count, albedo, id, light, states, rest);
        return;
    }
    // What counts in the picture is a mark of the sample, told apart by the way there
    Int8 marked = maxComponent(weight) * scene.exposure > c.quality.mark;
    Int8 mark = marked & hash(pick(in.path) ^ hash(id ^ hash(cell ^ states << 16)));
    addRest(c, in, run.ray + i, count, rest + albedo * light, mark);
    if (m.diffuse > 0 && m.texture.pattern != Pattern::Plain)
        for (int lanes = laneBits(marked) & ((1 << count) - 1); lanes; lanes &= lanes - 1)
            c.samples[in.sample[run.ray[i + __builtin_ctz((unsigned)lanes)]]].lights |= kTextured;
}

// Appends those of eight rays whose share counts to a stream.
struct Emitter {
    const Context &c;
    const RayStream &in;
    RayStream &out;
    Eight pick;
    Int8 active;

    void operator()(const Vec3x8 &o, const Vec3x8 &d, const Rgb8 &weight, Float8 width, Float8 spread,
                    int branch) const {
        int lanes = laneBits(active & (maxComponent(weight) * c.scene.exposure > c.quality.cutoff));
        if (!lanes) return;
        Int8 order = packedOrder(lanes);
        auto append = [&](auto *to, auto v) { store(to + out.count, permute(v, order)); };
        auto append3 = [&](float(&to)[3][kStream], Vec3x8 v) {
            append(to[0], v.x), append(to[1], v.y), append(to[2], v.z);
        };
        append3(out.o, o);
        append3(out.d, d);
        append3(out.weight, weight);
        append(out.width, width);
        append(out.spread, spread);
        append(out.sample, pick(in.sample));
        append(out.path, (Int8)((Uint8)pick(in.path) * 2u + (uint32_t)branch)); // the oldest falls out
        out.count += __builtin_popcount((unsigned)lanes);
    }
};

// Reflects and refracts eight rays where the surface does.
void scatter(const Context &c, const RayStream &in, RayStream &out, const Run &run, int i) {
    const Shape &shape = c.scene.shapes[run.shape];
    const Material &m = c.scene.materials[shape.material];
    Emitter emit = {c, in, out, Eight(run.ray + i), kLanes < run.count - i};
    Vec3x8 p = load(run.p, i), n = load(run.n, i), d = emit.pick(in.d);
    Rgb8 weight = load(run.weight, i);
    Float8 cosine = load(run.cosine + i), width = load(run.width + i), spread = emit.pick(in.spread);
    // A curved mirror widens what it throws back
    Float8 curve = {};
    if (shape.kind == ShapeKind::Sphere) curve = width / length(p - shape.centre);
    if (run.balls)
        for (int k = 0; k < 8; ++k) curve[k] = width[k] / c.scene.shapes[in.shape[run.ray[i + k]]].half.x;
    Float8 mirrorSpread = min(fmadd(curve, 2.f, spread), 1.f);
    Vec3x8 mirrored = normalize(fmadd(n, cosine * 2.f, d));
    Vec3x8 offset = n * load(run.error + i), outside = p + offset;
    if (m.ior > 0) {
        Float8 eta = select(load(run.side + i) > 0.f, 1.f / m.ior, m.ior);
        Float8 sine2 = eta * eta * fmadd(-cosine, cosine, 1.f);
        Float8 cosineT = sqrt(max(1.f - sine2, 0.f));
        // Fresnel's equations for both polarisations; beyond the critical angle all is reflected
        Float8 across = (eta * cosine - cosineT) / max(eta * cosine + cosineT, 1e-9f);
        Float8 along = (cosine - eta * cosineT) / max(cosine + eta * cosineT, 1e-9f);
        Float8 reflected = (across * across + along * along) * 0.5f, refracted = 1.f - reflected;
        if (m.transmit > 0) reflected = broadcast(m.reflect), refracted = broadcast(m.transmit);
        Int8 total = sine2 >= 1.f;
        reflected = select(total, 1.f, reflected);
        refracted = select(total, 0.f, refracted);
        emit(outside, mirrored, weight * reflected, width, mirrorSpread, 0);
        Vec3x8 bent = normalize(fmadd(n, eta * cosine - cosineT, d * eta));
        emit(p - offset, bent, weight * refracted, width, min(fmadd(curve, abs(eta - 1.f), spread), 1.f), 1);
    } else {
        Float8 reflected = broadcast(m.reflect);
        if (m.fresnel) {
            Float8 grazing = 1.f - cosine, square = grazing * grazing;
            reflected += (1.f - m.reflect) * square * square * grazing;
        }
        emit(outside, mirrored, weight * reflected * m.tint, width, mirrorSpread, 0);
    }
}

} // namespace

void shadeSky(const Context &c, const RayStream &in) {
    const Run &run = c.scratch.run;
    for (int i = 0; i < run.count; i += 8) {
        Eight pick(run.ray + i);
        Rgb8 weight = pick(in.weight), light = radiance(c.scene.sky, pick(in.d)) * weight;
        int count = min(run.count - i, 8);
        if (c.bounces == 0)
            begin(c, in, run.ray + i, count, Rgb8{}, Int8{}, Rgb8{}, Int8{}, light);
        else
            addRest(c, in, run.ray + i, count, light, hash(pick(in.path)) & (weight.y > c.quality.mark));
    }
}

void shade(const Context &c, const RayStream &in, RayStream &out) {
    Run &run = c.scratch.run;
    const Material &m = c.scene.materials[c.scene.shapes[run.shape].material];
    for (int i = 0; i < run.count; i += 8) arrive(c, in, run, i);
    if (m.diffuse > 0 || m.specular > 0) illuminate(c, in, run);
    for (int i = 0; i < run.count; i += 8) addShown(c, in, run, i);
    bool goesOn = c.bounces < c.quality.depth && (m.ior > 0 || m.reflect > 0);
    for (int i = 0; goesOn && i < run.count; i += 8) scatter(c, in, out, run, i);
}

Rgb8 albedoSeen(const Scene &scene, const View &view, const Shape &shape, Float8 x, Float8 y, float size) {
    const Material &m = scene.materials[shape.material];
    if (m.diffuse == 0) return broadcast(Rgb{});
    if (m.plain() && scene.lines == 0) return broadcast(m.texture.palette[0] * m.diffuse);
    Ray8 ray = {broadcast(view.eye), normalize(view.direction(x, y))};
    Int8 cell;
    if (shape.kind == ShapeKind::Plane && shape.aligned) { // most pixels of many scenes
        Float8 t = min(abs((shape.centre.y - view.eye.y) / ray.d.y), kFar);
        Vec3x8 p = fmadd(ray.d, t, ray.o);
        p.y = broadcast(shape.centre.y);
        return diffuseColour(scene, shape, p, ray.d, min(abs(ray.d.y), 1.f), t * (view.spread * size), cell);
    }
    Float8 t = distance(scene, shape, ray, Flat::Whole);
    Surface8 at = surfaceAt(shape, ray, t);
    Float8 cosine = min(abs(dot(at.n, ray.d)), 1.f);
    return diffuseColour(scene, shape, at.p, ray.d, cosine, t * (view.spread * size), cell);
}

} // namespace odraz
