#include "radiosity/visible.h"

#include "base/maths.h"
#include "trace/rays/intersect.h"

namespace odraz {

namespace {

void put(Vec3x8 &to, int k, Vec3 v) { to.x[k] = v.x, to.y[k] = v.y, to.z[k] = v.z; }

// Returns whether the nearest surface in a direction is a back: then the point is inside a solid. The
// tracer's rays stop only at fronts, but light stops at both sides.
Int8 seesBack(const Scene &scene, Vec3x8 p, Vec3x8 d, Int8 active) {
    Hit8 front = intersect(scene, {p, d}, active);
    Float8 open = transmittance(scene, {p, d}, min(front.t, kFar) * 0.9999f, active, broadcast(-1)).y;
    return active & (open < 0.5f);
}

// Tests rays in several directions, because one ray from inside a solid next to a wall may run along the wall
// and hit its front. They start on two sides of the point, so that points on a solid's edge count as inside.
Int8 insideSolid(const Scene &scene, const Texels8 &t, const TexelPoints8 &points) {
    Int8 some = {};
    for (int i = 0; i < 4; ++i) {
        float side = i & 1 ? -0.08f : 0.08f, slant = i & 2 ? 0.004f : 1;
        float a = side * 10 * slant, b = side * 8 * slant;
        Vec3x8 d = normalize(t.n + t.u * broadcast(a) + t.v * broadcast(b));
        some |= seesBack(scene, t.at(points.x + side, points.y + side), d, points.active);
    }
    return some;
}

// Returns whether a point is on a facet of its chart.
bool onFacet(const Model &model, const Chart &c, float u, float v) {
    float slack = (c.width + c.height) * 1e-6f;
    for (int i = c.firstFacet; i < c.firstFacet + c.facetCount; ++i) {
        const Facet &f = model.facets[i];
        if (u >= f.u[0] - slack && u <= f.u[2] + slack && v >= f.v[0] - slack && v <= f.v[2] + slack)
            return true;
    }
    return false;
}

} // namespace

Texels8 loadTexels(const Model &model, int first, int count) {
    Texels8 t;
    for (int k = 0; k < 8; ++k) {
        const Texel &texel = model.texels[first + min(k, count - 1)];
        const Chart &c = model.charts[texel.chart];
        float du = c.width / (float)c.across, dv = c.height / (float)c.down;
        put(t.p, k, c.at((float)texel.x * du, (float)texel.y * dv));
        put(t.u, k, c.u), put(t.v, k, c.v), put(t.n, k, c.n);
        t.du[k] = du * 0.25f, t.dv[k] = dv * 0.25f;
        t.off[k] = c.off();
    }
    t.active = kLanes < count;
    return t;
}

TexelPoints8 pointsOf(const int *masks, int round) {
    TexelPoints8 points = {};
    for (int k = 0; k < 8; ++k) {
        int mask = masks[k];
        for (int i = 0; i < round; ++i) mask &= mask - 1;
        if (!mask) continue;
        int index = __builtin_ctz((unsigned)mask);
        points.x[k] = index & 1 ? 1 : -1, points.y[k] = index & 2 ? 1 : -1;
        points.index[k] = index;
        points.active[k] = -1;
    }
    return points;
}

void findVisible(Model &model, const Scene &scene, Workers &workers) {
    parallelRanges(workers, model.texelCount, 64, [&](int first, int end, int) {
        for (int i = first; i < end; i += 8) {
            int count = min(end - i, 8), masks[8] = {}, visible[8] = {};
            for (int k = 0; k < 4 * count; ++k) {
                const Texel &t = model.texels[i + k / 4];
                const Chart &c = model.charts[t.chart];
                float u = (float)t.x + (k & 1 ? 0.25f : -0.25f), v = (float)t.y + (k & 2 ? 0.25f : -0.25f);
                masks[k / 4] |= onFacet(model, c, u * c.width / (float)c.across, v * c.height / (float)c.down)
                                << (k & 3);
            }
            Texels8 t = loadTexels(model, i, count);
            for (int round = 0; round < 4; ++round) {
                TexelPoints8 points = pointsOf(masks, round);
                if (!any(points.active)) break;
                Int8 open = points.active & ~insideSolid(scene, t, points);
                for (int k = 0; k < 8; ++k)
                    if (open[k]) visible[k] |= 1 << points.index[k];
            }
            for (int k = 0; k < count; ++k) model.texels[i + k].visible = (uint8_t)visible[k];
        }
    });
}

} // namespace odraz
