#include "trace/shade/diffuse.h"

namespace odraz {

// Converts a point to the coordinates of the shape's texture: the shape's frame, or the world's.
static Vec3x8 textureCoordinates(const Shape &s, Vec3x8 p) {
    if (s.traits().joins) return p;
    Vec3x8 q = p - s.centre;
    return s.aligned ? q : s.frame * q;
}

Rgb8 diffuseColour(const Scene &scene, const Shape &shape, const Vec3x8 &p, const Vec3x8 &d, Float8 cosine,
                   Float8 width, Int8 &cell) {
    const Material &m = scene.materials[shape.material];
    cell = Int8{};
    Rgb8 colour;
    if (m.plain()) {
        colour = broadcast(m.texture.palette[0] * m.diffuse);
    } else {
        Vec3x8 local = shape.traits().joins || shape.aligned ? d : shape.frame * d;
        colour = albedo(m, textureCoordinates(shape, p) + shape.textureShift, local, cosine, width, cell) *
                 broadcast(m.diffuse);
    }
    if (scene.lines != 0 && shape.chart >= 0) {
        Float8 clear;
        cell = patchAt(scene.lightmap->charts[shape.chart], p, d, cosine, width, clear);
        colour = colour * fmadd(clear - 1.f, scene.lines, 1.f);
    }
    return colour;
}

Rgb8 albedoSeen(const Scene &scene, const View &view, const Shape &shape, Float8 x, Float8 y, float size) {
    Ray8 ray = {broadcast(view.eye), normalize(view.direction(x, y))};
    Int8 cell;
    if (!shape.traits().solid) {
        const Vec3 n = shape.frame.v;
        Float8 slope = dot(ray.d, n), t = min(abs(dot(shape.centre - view.eye, n) / slope), kFar);
        return diffuseColour(scene, shape, fmadd(ray.d, t, ray.o), ray.d, min(abs(slope), 1.f),
                             t * (view.spread * size), cell);
    }
    Float8 t = distance(shape, ray, Flat::Whole);
    Surface8 at = surfaceAt(shape, ray, t);
    Float8 cosine = min(abs(dot(at.n, ray.d)), 1.f);
    return diffuseColour(scene, shape, at.p, ray.d, cosine, t * (view.spread * size), cell);
}

} // namespace odraz
