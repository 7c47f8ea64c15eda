#include "trace/whitted.h"

#include "base/maths.h"
#include "base/random.h"
#include "trace/ball.h"

namespace odraz {

namespace {

struct Context {
    const Scene &scene;
    const Quality &quality;
    TraceScratch &scratch;
    Sample *samples;
};

// Eight rays of a stream, taken together because they hit the same shape.
struct Packet {
    Int8 active;
    int ray[8]; // their places in the stream; lanes outside `active` repeat an active one
    int count;
    Ray8 r;
    Float8 t, width, spread;
    Rgb8 weight;
};

Float8 pick(const float *values, const int *index) { return gather(values, loadInts(index)); }
Vec3x8 pick(const float (&values)[3][kStream], const int *index) {
    return {pick(values[0], index), pick(values[1], index), pick(values[2], index)};
}

struct Lighting {
    Rgb8 diffuse, highlight;
    Int8 states; // as Sample::lights
};

// Light from all around, by the lightmap or ambient, less what the balls around take from it, then every
// light by Phong's formula and a shadow ray. Lights that would add less than a twentieth of the cutoff to the
// picture are left out, by `share`, the ray's own.
Lighting illuminate(const Context &c, const Shape &shape, const Material &m, const Surface8 &at, Vec3x8 n,
                    Float8 side, Vec3x8 d, Int8 active, Float8 share) {
    const Scene &scene = c.scene;
    float reflectance = maxComponent(scene.mean[shape.material]),
          least = c.quality.cutoff * 0.05f / scene.exposure;
    Float8 open = broadcast(1.f);
    for (int i = 0; i < scene.occluderCount; ++i) {
        Vec3x8 to = scene.occluder[i] - at.p;
        Float8 square = max(dot(to, to), 1e-12f), facing = dot(n, to);
        float r2 = scene.occluderRadius[i] * scene.occluderRadius[i];
        if (!any((facing > -scene.occluderRadius[i]) & (square < r2 * 400.f)))
            continue; // takes a four-hundredth
        if (shape.kind == ShapeKind::Sphere && sumAbs(shape.centre - scene.occluder[i]) == 0)
            continue; // itself
        open *= 1.f - clamp(ballFormFactor(facing / sqrt(square), r2 / square) - 0.0025f, 0.f, 0.95f);
    }
    Lighting result = {};
    if (shape.chart >= 0)
        result.diffuse = lightAt(*scene.lightmap, scene.lightmap->charts[shape.chart], at.p) * open;
    else
        result.diffuse =
            (broadcast(scene.ambientLow) + (scene.ambientHigh - scene.ambientLow) * fmadd(n.y, 0.5f, 0.5f)) *
            open;

    Vec3x8 origin = offsetOrigin(shape, at, side);
    Vec3x8 mirrored = fmadd(n, dot(n, d) * -2.f, d);
    float lobeEnd = m.specular > 0 ? exp2(-20 / m.exponent) : 1;
    for (int i = 0; i < scene.lightCount; ++i) {
        // Cut lanes that face away or stand outside the spot
        const Light &light = scene.lights[i];
        Vec3x8 to = light.position - origin;
        Float8 square = max(dot(to, to), 1e-8f), far = sqrt(square);
        Vec3x8 l = to * (1.f / far);
        Float8 cosine = dot(n, l);
        Float8 strength = 1.f / square;
        if (light.cosOuter > -1.5f)
            strength *= smoothstep(light.cosOuter, light.cosInner, -dot(light.direction, l));
        // Highlights end at 2^-20: powers of smaller cosines are denormal numbers, and those cost 100 cycles
        // each
        Float8 lobe = {}, towards = dot(mirrored, l);
        if (any(towards > lobeEnd))
            lobe = select(towards > lobeEnd, pow(towards, m.exponent) * m.specular, 0.f);
        Float8 promised =
            fmadd(cosine, reflectance, lobe) * (strength * share) * maxComponent(light.intensity);
        Int8 lit = active & (cosine > 0.f) & (promised > least);
        if (!any(lit)) continue;
        // Add what its shadow ray lets through
        Rgb8 through = transmittance(scene, {origin, l}, far, lit, c.scratch.blocker[i]);
        Float8 most = maxComponent(through);
        lit &= most > 0.f;
        if (!any(lit)) continue;
        Rgb8 arriving = through * select(lit, strength, 0.f) * light.intensity;
        result.diffuse += arriving * cosine;
        result.highlight += arriving * lobe;
        Int8 state = select(through.x + through.y + through.z < 3.f, broadcast(3),
                            select(lobe > 0.02f, broadcast(2), broadcast(1)));
        result.states |= (lit & state) << (2 * i);
    }
    return result;
}

void addTo(Rgb &sum, const Rgb8 &value, int lane) { sum += Rgb{value.x[lane], value.y[lane], value.z[lane]}; }

// Appends the lanes of `active` to a stream.
void emit(const Context &c, RayStream &out, const RayStream &in, const Packet &p, Vec3x8 o, Vec3x8 d,
          Rgb8 weight, Float8 width, Float8 spread, uint32_t branch) {
    int lanes = laneBits(p.active & (maxComponent(weight) * c.scene.exposure > c.quality.cutoff));
    for (; lanes; lanes &= lanes - 1) {
        int k = __builtin_ctz(lanes), i = out.count++;
        out.o[0][i] = o.x[k], out.o[1][i] = o.y[k], out.o[2][i] = o.z[k];
        out.d[0][i] = d.x[k], out.d[1][i] = d.y[k], out.d[2][i] = d.z[k];
        out.weight[0][i] = weight.x[k], out.weight[1][i] = weight.y[k], out.weight[2][i] = weight.z[k];
        out.width[i] = width[k];
        out.spread[i] = spread[k];
        out.sample[i] = in.sample[p.ray[k]];
        out.path[i] = in.path[p.ray[k]] * 2 + branch;
    }
}

void shadeSky(const Context &c, const RayStream &in, const Packet &p) {
    Rgb8 light = radiance(c.scene.sky, p.r.d) * p.weight;
    for (int k = 0; k < p.count; ++k) {
        Sample &s = c.samples[in.sample[p.ray[k]]];
        addTo(s.rest, light, k);
        if (in.path[p.ray[k]] > 1 && p.weight.y[k] > c.quality.mark) s.secondary += pcg(in.path[p.ray[k]]);
    }
}

// Reflects and refracts where the surface does.
void scatter(const Context &c, const RayStream &in, RayStream &out, const Packet &p, const Shape &shape,
             const Material &m, const Surface8 &at, Vec3x8 n, Float8 side, Float8 cosine, Float8 width,
             Rgb8 weight) {
    const Vec3x8 &d = p.r.d;
    // A curved mirror widens what it throws back
    Float8 curve = broadcast(shape.kind == ShapeKind::Sphere ? 1.f / shape.half.x : 0.f);
    Float8 mirrorSpread = min(fmadd(width * curve, 2.f / max(cosine, 0.1f), p.spread), 1.f);
    Vec3x8 mirrored = normalize(fmadd(n, dot(n, d) * -2.f, d));
    Vec3x8 outside = offsetOrigin(shape, at, side);
    if (m.ior > 0) {
        Float8 eta = select(side > 0.f, 1.f / m.ior, m.ior);
        Float8 sine2 = eta * eta * fmadd(-cosine, cosine, 1.f);
        Float8 cosineT = sqrt(max(1.f - sine2, 0.f));
        // Fresnel's equations for both polarisations; beyond the critical angle all is reflected
        Float8 across = (eta * cosine - cosineT) / max(eta * cosine + cosineT, 1e-9f);
        Float8 along = (cosine - eta * cosineT) / max(cosine + eta * cosineT, 1e-9f);
        Float8 reflected = select(sine2 >= 1.f, 1.f, (across * across + along * along) * 0.5f);
        Vec3x8 bent = normalize(fmadd(n, eta * cosine - cosineT, d * eta));
        emit(c, out, in, p, outside, mirrored, weight * reflected, width, mirrorSpread, 0);
        Float8 bentSpread = min(fmadd(width * curve, abs(eta - 1.f), p.spread), 1.f);
        emit(c, out, in, p, offsetOrigin(shape, at, -side), bent, weight * (1.f - reflected), width,
             bentSpread, 1);
    } else if (m.reflect > 0) {
        Float8 reflected = broadcast(m.reflect);
        if (m.fresnel) {
            Float8 grazing = 1.f - cosine, square = grazing * grazing;
            reflected += (1.f - m.reflect) * square * square * grazing;
        }
        emit(c, out, in, p, outside, mirrored, weight * reflected * m.tint, width, mirrorSpread, 0);
    }
}

// The diffuse colour of a place. In a scene that shows its patches it has the lines between them, and `cell`
// tells the patches apart.
Rgb8 diffuseColour(const Scene &scene, const Shape &shape, const Surface8 &at, Vec3x8 d, Float8 cosine,
                   Float8 width, Int8 &cell) {
    const Material &m = scene.materials[shape.material];
    Vec3x8 local = shape.kind == ShapeKind::Rect ? d : shape.frame * d;
    Rgb8 colour = albedo(m, at.local + shape.textureShift, local, cosine, width, cell) * broadcast(m.diffuse);
    if (scene.lines > 0 && shape.chart >= 0) {
        Float8 clear;
        cell = patchAt(scene.lightmap->charts[shape.chart], at.p, width / sqrt(max(cosine, 0.02f)), clear);
        colour = colour * fmadd(clear - 1.f, scene.lines, 1.f);
    }
    return colour;
}

void shade(const Context &c, const RayStream &in, RayStream &out, const Packet &p, int shapeIndex) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[shapeIndex];
    const Material &m = scene.materials[shape.material];
    // Turn the normal to the side that the ray came from
    Surface8 at = surfaceAt(shape, p.r, p.t);
    Float8 side = select(dot(at.n, p.r.d) > 0.f, -1.f, 1.f);
    Vec3x8 n = at.n * side;
    Float8 cosine = clamp(-dot(n, p.r.d), 0.f, 1.f);
    Float8 width = fmadd(p.spread, p.t, p.width);

    // Weaken by what was passed: fog on the way, glass if the ray comes from inside
    Rgb8 weight = p.weight;
    Rgb8 haze = {};
    if (scene.fog > 0) {
        Float8 clear = exp2(p.t * -scene.fog);
        haze = radiance(scene.sky, p.r.d) * weight * (1.f - clear);
        weight = weight * clear;
    }
    if (m.ior > 0) {
        auto through = [&](float absorb) { return select(side < 0.f, exp2(p.t * -absorb), 1.f); };
        weight = weight * Rgb8{through(m.absorb.x), through(m.absorb.y), through(m.absorb.z)};
    }

    Int8 cell = {};
    Rgb8 diffuse = {};
    Lighting lighting = {};
    if (m.diffuse > 0 || m.specular > 0) {
        if (m.diffuse > 0) diffuse = diffuseColour(scene, shape, at, p.r.d, cosine, width, cell);
        // Inside glass there are no highlights: its lights come by refraction
        Int8 litSide = m.ior > 0 ? p.active & (side > 0.f) : p.active;
        if (any(litSide))
            lighting = illuminate(c, shape, m, at, n, side, p.r.d, litSide, maxComponent(weight));
    }
    Rgb8 rest = haze + weight * (lighting.highlight + broadcast(m.emit));
    Rgb8 light = lighting.diffuse * weight;

    // Add to the samples
    bool primary = in.path[p.ray[0]] == 1;
    int marked = laneBits(maxComponent(weight) * scene.exposure > c.quality.mark);
    for (int k = 0; k < p.count; ++k) {
        Sample &s = c.samples[in.sample[p.ray[k]]];
        uint32_t id = 1 + 8 * (uint32_t)shapeIndex + (uint32_t)at.face[k];
        addTo(s.rest, rest, k);
        if (primary) {
            addTo(s.albedo, diffuse, k);
            addTo(s.light, light, k);
            s.id = id;
            s.lights = (uint32_t)lighting.states[k];
            if (scene.lines > 0) s.lights += (uint32_t)cell[k] << 16; // a mosaic: patches end abruptly
        } else {
            addTo(s.rest, diffuse * light, k);
            if (!(marked >> k & 1)) continue;
            s.textured |= m.diffuse > 0 && m.texture.pattern != Pattern::Plain;
            s.secondary += pcg(in.path[p.ray[k]] ^
                               pcg(id ^ pcg((uint32_t)cell[k] ^ (uint32_t)lighting.states[k] << 16)));
        }
    }
    bool mayGoOn = in.path[p.ray[0]] >> c.quality.depth == 0;
    if (mayGoOn) scatter(c, in, out, p, shape, m, at, n, side, cosine, width, weight);
}

// Intersects and shades rays [begin, end) of a stream.
void shadeChunk(const Context &c, const RayStream &in, RayStream &out, int begin, int end) {
    // Find what each ray hits
    float t[kChunk];
    int shape[kChunk];
    for (int i = begin; i < end; i += 8) {
        Ray8 ray = {{load(in.o[0] + i), load(in.o[1] + i), load(in.o[2] + i)},
                    {load(in.d[0] + i), load(in.d[1] + i), load(in.d[2] + i)}};
        Hit8 hit = intersect(c.scene, ray, kLanes < end - i);
        store(t + i - begin, hit.t);
        store(shape + i - begin, hit.shape);
    }

    // Sort by shape: count, list what occurs in order, place
    int *rays = c.scratch.shapeRays; // by shape + 1
    uint16_t present[kChunk];
    int kinds = 0;
    for (int i = 0; i < end - begin; ++i)
        if (rays[shape[i] + 1]++ == 0) present[kinds++] = (uint16_t)(shape[i] + 1);
    for (int i = 1; i < kinds; ++i) {
        uint16_t moved = present[i];
        int j = i;
        for (; j > 0 && present[j - 1] > moved; --j) present[j] = present[j - 1];
        present[j] = moved;
    }
    int start[kChunk + 1], place = 0;
    for (int i = 0; i < kinds; ++i) {
        start[i] = place;
        place += rays[present[i]];
        rays[present[i]] = start[i];
    }
    start[kinds] = place;
    int sorted[kChunk + 8];
    for (int i = 0; i < end - begin; ++i) sorted[rays[shape[i] + 1]++] = i;

    // Shade shape by shape
    for (int run = 0; run < kinds; ++run) {
        rays[present[run]] = 0;
        for (int first = start[run]; first < start[run + 1]; first += 8) {
            Packet p;
            p.count = min(start[run + 1] - first, 8);
            p.active = kLanes < p.count;
            int local[8];
            for (int k = 0; k < 8; ++k) {
                local[k] = sorted[first + (k < p.count ? k : 0)];
                p.ray[k] = begin + local[k];
            }
            p.r = {pick(in.o, p.ray), pick(in.d, p.ray)};
            p.t = pick(t, local);
            p.width = pick(in.width, p.ray);
            p.spread = pick(in.spread, p.ray);
            p.weight = pick(in.weight, p.ray);
            if (present[run] == 0)
                shadeSky(c, in, p);
            else
                shade(c, in, out, p, present[run] - 1);
        }
    }
}

void traceStream(const Context &c, int level) {
    RayStream &in = c.scratch.streams[level], &out = c.scratch.streams[level + 1];
    for (int begin = 0; begin < in.count; begin += kChunk) {
        int end = min(begin + kChunk, in.count);
        out.count = 0;
        shadeChunk(c, in, out, begin, end);
        if (out.count) traceStream(c, level + 1);
    }
}

} // namespace

void traceSamples(const Scene &scene, const View &view, const Quality &quality, TraceScratch &scratch,
                  int count, const float *x, const float *y, const uint32_t *index, Sample *samples) {
    Context c = {scene, quality, scratch, samples};
    for (int &blocker : scratch.blocker) blocker = -1; // of another scene, perhaps
    RayStream &stream = scratch.streams[0];
    for (int first = 0; first < count; first += kChunk) {
        stream.count = min(count - first, kChunk);
        for (int i = 0; i < stream.count; ++i) {
            Vec3 d = normalize(view.direction(x[first + i], y[first + i]));
            stream.o[0][i] = view.eye.x, stream.o[1][i] = view.eye.y, stream.o[2][i] = view.eye.z;
            stream.d[0][i] = d.x, stream.d[1][i] = d.y, stream.d[2][i] = d.z;
            stream.weight[0][i] = stream.weight[1][i] = stream.weight[2][i] = 1;
            stream.width[i] = 0;
            stream.spread[i] = view.spread;
            stream.sample[i] = index[first + i];
            stream.path[i] = 1;
            samples[index[first + i]] = {};
        }
        traceStream(c, 0);
    }
}

Rgb8 albedoSeen(const Scene &scene, const View &view, const Shape &shape, Float8 x, Float8 y) {
    const Material &m = scene.materials[shape.material];
    if (m.diffuse == 0) return broadcast(Rgb{});
    if (m.texture.pattern == Pattern::Plain && m.cell == 0 && scene.lines == 0)
        return broadcast(m.texture.palette[0] * m.diffuse);
    Ray8 ray = {broadcast(view.eye), normalize(view.direction(x, y))};
    Float8 t = distance(scene, shape, ray, true);
    Surface8 at = surfaceAt(shape, ray, t);
    Float8 cosine = min(abs(dot(at.n, ray.d)), 1.f);
    Int8 cell;
    return diffuseColour(scene, shape, at, ray.d, cosine, t * view.spread, cell);
}

} // namespace odraz
