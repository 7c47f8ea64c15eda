#include "radiosity/hemicube.h"
#include "trace/rays/intersect.h"

namespace odraz {

namespace {

// Returns the directions, in the hemicube's frame, of eight pixels of the row y, from x on.
Vec3x8 directionsOf(int px, int x, int y) {
    float pixel = 2 / (float)px;
    Float8 a = (toFloat(kLanes + x) + 0.5f) * pixel - 1;
    float row = ((float)y + 0.5f) * pixel - 1; // the top face has -1 .. 1, each side 1 more
    if (row < 1) return {a, broadcast(row), broadcast(1.f)};
    int side = (int)row;
    Vec3x8 d = {broadcast(1.f), a, broadcast(row - (float)side)};
    for (; side > 1; --side) d = {-d.y, d.x, d.z}; // to the next side, a quarter turn further
    return d;
}

// Returns the ids of the patches that rays from p along d show.
Uint8 traced(const Scene &scene, const Model &model, Vec3 p, Vec3x8 d) {
    Hit8 hit = intersect(scene, {broadcast(p), d}, kLanes >= 0);
    Int8 hitChart, ids = {};
    for (int k = 0; k < 8; ++k) hitChart[k] = hit.shape[k] < 0 ? -1 : scene.shapes[hit.shape[k]].chart;
    for (int i = 0; i < model.chartCount; ++i) {
        const Chart &c = model.charts[i];
        Int8 here = hitChart == (c.open ? -1 : i); // a ray that hits nothing leaves by a window
        if (!any(here)) continue;
        Float8 towards = dot(d, c.n), t = dot(c.corner - p, c.n) / towards;
        Vec3x8 q = d * t + broadcast(p - c.corner);
        Float8 x = dot(q, c.u) * ((float)c.patchesAcross / c.width),
               y = dot(q, c.v) * ((float)c.patchesDown / c.height);
        Int8 column = toInt(clamp(x, 0.f, (float)c.patchesAcross - 0.5f)),
             line = toInt(clamp(y, 0.f, (float)c.patchesDown - 0.5f));
        if (c.open)
            here &= (towards < 0.f) & (t > 0.f) & (x >= 0.f) & (x <= (float)c.patchesAcross) & (y >= 0.f) &
                    (y <= (float)c.patchesDown);
        ids = select(here, line * c.patchesAcross + column + c.firstPatch + 1, ids);
    }
    return (Uint8)ids;
}

bool open(Hemicubes &h, const Gl *, const Scene &scene, Arena &arena, int px) {
    h = {};
    h.scene = &scene;
    shapeAtlas(h, px);
    h.ids = arena.allocate<uint32_t>((size_t)h.batch * (size_t)(3 * px * px));
    return !arena.full;
}

bool fill(Hemicubes &h, const Model &model, const Eye *eyes, int count) {
    for (int i = 0; i < count; ++i) {
        uint32_t *row = (uint32_t *)hemicubeIds(h, i);
        const Mat3 &frame = eyes[i].frame;
        for (int y = 0; y < 3 * h.px; ++y, row += hemicubeStride(h))
            for (int x = 0; x < h.px; x += 8) {
                Vec3x8 d = directionsOf(h.px, x, y);
                d = normalize(frame.u * d.x + frame.v * d.y + frame.w * d.z);
                Uint8 ids = traced(*h.scene, model, eyes[i].p, d);
                __builtin_memcpy(row + x, &ids, sizeof ids);
            }
    }
    return true;
}

} // namespace

const HemicubeMethod kTracedHemicubes = {open, fill, [](Hemicubes &) {}};

} // namespace odraz
