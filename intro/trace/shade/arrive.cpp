#include "trace/shade/arrive.h"

#include "base/maths.h"

namespace odraz {

// Computes eight hits of a run.
static void arriveEight(const Shading &c, const RayStream &in, Run &run, int i) {
    const Scene &scene = c.scene;
    const Shape &shape = scene.shapes[run.shape];
    const Material &m = scene.materials[shape.material];
    EightRays rays(run.ray + i);
    Ray8 ray = {rays(in.o), rays(in.d)};
    Float8 t = rays(in.t);
    Vec3x8 p, n;
    Int8 id;
    Float8 size, spread = rays(in.spread), width = rays(in.width), curve = {};
    if (run.balls) {
        // Each lane has its own ball
        Int8 index = rays(in.shape);
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
        curve = 1.f / radius;
        id = packHit(index, 0);
    } else {
        Surface8 at = surfaceAt(shape, ray, t);
        p = at.p, n = at.n;
        size = broadcast(magnitude(shape));
        if (shape.isBall()) curve = broadcast(1 / shape.half.x);
        id = packHit(run.shape, at.face);
    }
    // Turn the normal to the side that the ray came from
    Float8 side = select(dot(n, ray.d) > 0.f, -1.f, 1.f);
    n = n * side;
    // A ball of glass focuses what enters it: inside it a sample hardly widens
    width = fmadd(spread, select(side > 0.f, t, t * 0.3f), width);
    store(run.p, i, p);
    store(run.n, i, n);
    store(run.d, i, ray.d);
    store(run.spread + i, spread);
    store(run.side + i, side);
    store(run.error + i, errorBound(p, size));
    store(run.cosine + i, clamp(-dot(n, ray.d), 0.f, 1.f));
    store(run.width + i, width);
    store(run.curve + i, curve * width);
    store(run.id + i, id);

    // Weaken the ray by fog and, if it comes from inside, by glass
    Rgb8 weight = rays(in.weight);
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

void arrive(const Shading &c, const RayStream &in, Run &run) {
    for (int i = 0; i < run.count; i += 8) arriveEight(c, in, run, i);
}

} // namespace odraz
