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

// Lambert's formula, a sum over the edges, for the rectangle of sides u and v about q. What lies under the
// horizon counts negative: it should be little of it.
Float8 rectangleFormFactor(Vec3x8 p, Vec3 n, Vec3 q, Vec3 u, Vec3 v) {
    const float signs[4][2] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
    auto towards = [&](int k) {
        return normalize(q + u * (signs[k][0] * 0.5f) + v * (signs[k][1] * 0.5f) - p);
    };
    Float8 sum = {};
    Vec3x8 a = towards(3);
    for (int k = 0; k < 4; ++k) {
        Vec3x8 b = towards(k);
        Float8 angle = acos(clamp(dot(a, b), -1.f, 1.f));
        sum = fmadd(angle, dot(normalize(cross(a, b)), n), sum);
        a = b;
    }
    return max(sum, 0.f) * (0.5f / kPi);
}
constexpr float kNear = 16; // distance^2 over a cell's area within which discs would not do

constexpr int kCells = 32;

// A cell of something that shines, from eight places.
struct Seen {
    Vec3x8 d;
    Float8 factor;
};

struct Sums {
    Float8 sky[kMaxSkies][3], single[kMaxBases];
};

struct Context {
    const Model &model;
    const Scene &scene;
    const Lights &lights;

    // What share of the way to points `to` is clear.
    Float8 clear(const Places &at, Vec3x8 to, Int8 active, Vec3x8 &d) {
        to = to - at.p;
        Float8 distance = max(length(to), 1e-20f);
        d = to * (1.f / distance);
        return transmittance(scene, {at.p, d}, distance * 0.9999f, active, broadcast(-1)).y;
    }

    // Finds the directions and form factors of the cells of a chart that this place looks at: every fourth,
    // where it is near all of them. Returns how many.
    int look(const Places &at, const Chart &c, Seen *seen) {
        // Cells as square as can be
        int across = c.width > 2 * c.height ? 16 : 2 * c.width > c.height ? 8 : 2, count = 0;
        Vec3 u = c.u * (c.width / (float)across), v = c.v * (c.height * (float)across / kCells);
        float area = length(u) * length(v);
        Vec3x8 from = at.p - c.corner;
        Float8 s = dot(from, c.u), t = dot(from, c.v), h = dot(from, c.n);
        Float8 ds = s - clamp(s, 0.f, c.width), dt = t - clamp(t, 0.f, c.height);
        bool near = any(at.active & (fmadd(ds, ds, fmadd(dt, dt, h * h)) < area * kNear) & (h > 0.f));
        for (int k = 0; k < kCells; ++k) {
            int i = k % across, j = k / across;
            if (!near && ((i + 2 * j) & 3) != at.place) continue;
            Vec3 q = c.corner + u * ((float)i + 0.5f) + v * ((float)j + 0.5f);
            Vec3x8 to = q - at.p;
            Float8 square = dot(to, to), cosines = max(dot(to, at.n), 0.f) * h;
            Int8 faces = at.active & (cosines > 0.f);
            if (!any(faces)) continue;
            Seen &cell = seen[count++];
            Float8 share = clear(at, broadcast(q), faces, cell.d);
            Float8 factor = near ? rectangleFormFactor(at.p, at.n, q, u, v)
                                 : cosines / square * (4 * area) / fmadd(square, kPi, broadcast(area));
            cell.factor = select(faces, factor * share, 0.f);
        }
        return count;
    }

    void add(const Places &at, Sums &sums);
};

void Context::add(const Places &at, Sums &sums) {
    Seen seen[kCells];
    for (int w = 0; w < model.chartCount; ++w) {
        if (!model.charts[w].open) continue;
        for (int i = look(at, model.charts[w], seen) - 1; i >= 0; --i)
            for (int k = 0; k < lights.skyCount && any(seen[i].factor > 0.f); ++k) {
                Rgb8 light = radiance(lights.skies[k].sky, seen[i].d) * seen[i].factor;
                sums.sky[k][0] += light.x, sums.sky[k][1] += light.y, sums.sky[k][2] += light.z;
            }
    }
    Vec3x8 d;
    for (int k = 0; k < lights.skyCount; ++k) {
        if (maxComponent(lights.skies[k].sunlight) == 0) continue;
        Vec3 sun = lights.skies[k].sunAt;
        Int8 faces = at.active & (dot(sun - at.p, at.n) > 0.f);
        if (!any(faces)) continue;
        Float8 share = clear(at, broadcast(sun), faces, d);
        sums.single[k] += select(faces, share * dot(d, at.n), 0.f);
    }
    for (int k = 0; k < lights.lampCount; ++k) {
        const Lamp &lamp = lights.lamps[k];
        Float8 &sum = sums.single[lights.skyCount + k];
        if (lamp.radius == 0) {
            for (int i = look(at, model.charts[lamp.chart], seen) - 1; i >= 0; --i) sum += seen[i].factor;
            continue;
        }
        // Aim at a point of the disc that the ball shows, another from every place
        Vec3x8 to = lamp.centre - at.p;
        Float8 far = max(length(to), 1e-20f);
        Float8 factor = ballFormFactor(dot(to, at.n) / far, lamp.radius * lamp.radius / (far * far));
        Int8 lit = at.active & (factor > 0.f);
        if (!any(lit)) continue;
        Vec3x8 side = normalize(cross(to, Vec3x8{to.y, to.z, -to.x}));
        Vec3x8 up = normalize(cross(to, side));
        float x = at.place & 1 ? 0.5f : -0.5f, y = at.place & 2 ? 0.5f : -0.5f;
        Vec3x8 target = (side * broadcast(x) + up * broadcast(y)) * broadcast(lamp.radius) + lamp.centre;
        sum += select(lit, factor * clear(at, target, lit, d), 0.f);
    }
}

// Stores the first `count` lanes.
void put(float *plane, Float8 x, int count) { _mm256_maskstore_ps(plane, (__m256i)(kLanes < count), x); }

} // namespace

void findDirectLight(const Model &model, const Scene &scene, const Lights &lights, Workers &workers,
                     float *const (*sky)[3], float *const *single, const Progress &progress) {
    int done = 0; // texels
    parallelFor(workers, model.chartCount, [&](int index, int worker) {
        const Chart &c = model.charts[index];
        Context context = {model, scene, lights};
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
                    context.add({p, c.n, active, place}, sums);
                }
                Float8 inverse = 1.f / max(places, 1.f);
                for (int k = 0; k < lights.skyCount; ++k)
                    for (int channel = 0; channel < 3; ++channel)
                        put(sky[k][channel] + texel, sums.sky[k][channel] * inverse, count);
                for (int k = 0; k < lights.bases(); ++k)
                    put(single[k] + texel, sums.single[k] * inverse, count);
            }
        int texels = __atomic_add_fetch(&done, c.texels(), __ATOMIC_RELAXED);
        if (worker == 0) progress((float)texels / (float)model.texelCount);
    });
}

} // namespace odraz
