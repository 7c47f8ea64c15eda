#include "trace/shade/arrive.h"

#include "base/maths.h"

namespace odraz {

// Eight surface points. size: magnitude of the shape, for errorBound(); curve: 1 / radius of a ball, else 0.
struct Surfaces {
    Vec3x8 p, n;
    Int8 id;
    Float8 size, curve = {};
};

// Computes the points on balls, one ball in each lane.
ODRAZ_INLINE static void hitBalls(const Scene &scene, Int8 index, const Ray8 &ray, Float8 t, Surfaces &at) {
    int32_t ball[8];
    store(ball, index);
    Vec3x8 centre;
    Float8 radius;
    for (int k = 0; k < 8; ++k) {
        const Shape &s = scene.shapes[ball[k]];
        centre.x[k] = s.centre.x, centre.y[k] = s.centre.y, centre.z[k] = s.centre.z;
        radius[k] = s.half.x;
    }
    at.n = normalize(fmadd(ray.d, t, ray.o - centre));
    at.p = fmadd(at.n, radius, centre);
    at.size = sumAbs(centre) + radius;
    at.curve = 1.f / radius;
    at.id = packHit(index, 0);
}

// Computes the points on one shape.
ODRAZ_INLINE static void hitShape(const Scene &scene, int index, const Ray8 &ray, Float8 t, Surfaces &at) {
    const Shape &shape = scene.shapes[index];
    Surface8 surface = surfaceAt(shape, ray, t);
    at.p = surface.p, at.n = surface.n;
    at.size = broadcast(magnitude(shape));
    if (shape.isBall()) at.curve = broadcast(1 / shape.half.x);
    at.id = packHit(index, surface.face);
}

// Computes eight hits of a run.
static void arriveEight(const Shading &c, const RayStream &in, Run &run, int i) {
    const Scene &scene = c.scene;
    const Material &m = scene.materials[scene.shapes[run.shape].material];
    EightRays rays(run.ray + i);
    Ray8 ray = {rays(in.o), rays(in.d)};
    Float8 t = rays(in.t), spread = rays(in.spread), width = rays(in.width);
    Surfaces at;
    if (run.balls)
        hitBalls(scene, rays(in.shape), ray, t, at);
    else
        hitShape(scene, run.shape, ray, t, at);
    // Turn the normal to the side that the ray came from
    auto [p, n, id, size, curve] = at;
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
