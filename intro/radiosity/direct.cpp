#include "radiosity/direct.h"

#include "base/maths.h"
#include "trace/ball.h"
#include "trace/intersect.h"

namespace odraz {

namespace {

// Eight neighbouring elements, seen from one of their four places.
struct Places {
    Vec3x8 p; // just off the surface
    Vec3 n;
    Int8 active;
    int place; // 0 .. 3
};

struct Context {
    const Model &model;
    const Scene &scene;
    const Lights &lights;
    int blocker;

    // What share of the way to points `to` is clear.
    Float8 clear(const Places &at, Vec3x8 to, Int8 active, Vec3x8 &d, Float8 &distance) {
        to = to - at.p;
        distance = max(length(to), 1e-20f);
        d = to * (1.f / distance);
        return transmittance(scene, {at.p, d}, distance * 0.9999f, active, blocker).y;
    }

    // Calls visit(direction, form factor) for the cells of a chart that this place looks at.
    template <class Visit> void cells(const Places &at, const Chart &c, Visit &&visit) {
        // Cells as square as can be
        int across = c.width > 2 * c.height ? 16 : 2 * c.width > c.height ? 8 : 2, down = 32 / across;
        float area = c.width * c.height / 32;
        for (int k = 0; k < 32; ++k) {
            int i = k % across, j = k / across;
            if (((i + 2 * j) & 3) != at.place) continue;
            Vec3 q =
                c.at(((float)i + 0.5f) * c.width / (float)across, ((float)j + 0.5f) * c.height / (float)down);
            Vec3x8 to = q - at.p;
            Float8 square = dot(to, to), cosines = max(dot(to, at.n), 0.f) * max(-dot(to, c.n), 0.f);
            Int8 faces = at.active & (cosines > 0.f);
            if (!any(faces)) continue;
            Vec3x8 d;
            Float8 distance, share = clear(at, broadcast(q), faces, d, distance);
            Float8 factor = cosines / square * (4 * area) / fmadd(square, kPi, broadcast(area));
            visit(d, select(faces, factor * share, 0.f));
        }
    }
};

struct Sums {
    Float8 sky[kMaxSkies][3], single[kMaxBases];
};

void look(Context &c, const Places &at, Sums &sums) {
    const Lights &lights = c.lights;
    for (int w = 0; w < c.model.chartCount; ++w) {
        const Chart &window = c.model.charts[w];
        if (!window.open) continue;
        c.cells(at, window, [&](Vec3x8 d, Float8 factor) {
            if (!any(factor > 0.f)) return;
            for (int k = 0; k < lights.skyCount; ++k) {
                Rgb8 light = radiance(lights.skies[k].sky, d) * factor;
                sums.sky[k][0] += light.x, sums.sky[k][1] += light.y, sums.sky[k][2] += light.z;
            }
        });
    }
    Vec3x8 d;
    Float8 distance;
    for (int k = 0; k < lights.skyCount; ++k) {
        if (maxComponent(lights.skies[k].sunlight) == 0) continue;
        Vec3 sun = lights.skies[k].sunAt;
        Int8 faces = at.active & (dot(sun - at.p, at.n) > 0.f);
        if (!any(faces)) continue;
        Float8 share = c.clear(at, broadcast(sun), faces, d, distance);
        sums.single[k] += select(faces, share * dot(d, at.n), 0.f);
    }
    for (int k = 0; k < lights.lampCount; ++k) {
        const Lamp &lamp = lights.lamps[k];
        Float8 &sum = sums.single[lights.skyCount + k];
        if (lamp.radius == 0) {
            c.cells(at, c.model.charts[lamp.chart], [&](Vec3x8, Float8 factor) { sum += factor; });
            continue;
        }
        // Aim at a point of the disc that the ball shows, another from every place
        Vec3x8 to = lamp.centre - at.p;
        Float8 far = max(length(to), 1e-20f), cosine = dot(to, at.n) / far;
        Float8 factor = ballFormFactor(cosine, lamp.radius * lamp.radius / (far * far));
        Int8 lit = at.active & (factor > 0.f);
        if (!any(lit)) continue;
        Vec3x8 side = normalize(cross(to, Vec3x8{to.y, to.z, -to.x}));
        Vec3x8 up = normalize(cross(to, side));
        float x = at.place & 1 ? 0.5f : -0.5f, y = at.place & 2 ? 0.5f : -0.5f;
        Vec3x8 target = (side * broadcast(x) + up * broadcast(y)) * broadcast(lamp.radius) + lamp.centre;
        sum += select(lit, factor * c.clear(at, target, lit, d, distance), 0.f);
    }
}

// Stores the first `count` lanes.
void put(float *plane, Float8 x, int count) { _mm256_maskstore_ps(plane, (__m256i)(kLanes < count), x); }

} // namespace

void findDirectLight(const Model &model, const Scene &scene, const Lights &lights, Workers &workers,
                     DirectLight &out, const Progress &progress) {
    int done = 0; // texels
    parallelFor(workers, model.chartCount, [&](int index, int worker) {
        const Chart &c = model.charts[index];
        Context context = {model, scene, lights, -1};
        float du = c.width / (float)c.across, dv = c.height / (float)c.down;
        float off = (sumAbs(c.corner) + c.width + c.height) * 2e-6f;
        for (int j = 0; j < c.down && !c.open; ++j)
            for (int i0 = 0; i0 < c.across; i0 += 8) {
                int count = min(c.across - i0, 8), texel = c.texel(i0, j);
                int seen[8] = {};
                for (int k = 0; k < count; ++k) seen[k] = model.visible[texel + k];
                Sums sums = {};
                Float8 places = {};
                for (int place = 0; place < 4; ++place) {
                    Int8 active = (loadInts(seen) >> place & 1) != 0;
                    if (!any(active)) continue;
                    places += select(active, 1.f, 0.f);
                    Float8 u = (toFloat(kLanes + i0) + placeU(place)) * du;
                    Vec3x8 p = c.u * u + (c.corner + c.v * (((float)j + placeV(place)) * dv) + c.n * off);
                    look(context, {p, c.n, active, place}, sums);
                }
                Float8 inverse = 1.f / max(places, 1.f);
                for (int k = 0; k < lights.skyCount; ++k)
                    for (int channel = 0; channel < 3; ++channel)
                        put(out.sky[k][channel] + texel, sums.sky[k][channel] * inverse, count);
                for (int k = 0; k < lights.bases(); ++k)
                    put(out.single[k] + texel, sums.single[k] * inverse, count);
            }
        int texels = __atomic_add_fetch(&done, c.texels(), __ATOMIC_RELAXED);
        if (worker == 0) progress((float)texels / (float)model.texelCount);
    });
}

} // namespace odraz
