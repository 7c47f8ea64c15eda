#include "tools/measure/reference.h"

#include "tools/radiosity/facets.h"

#include "base/random.h"
#include "trace/rays/intersect.h"

#include <algorithm>
#include <cmath>

namespace odraz {

namespace {

float random(uint32_t &state) { return unitFloat(state = pcg(state)); }

// Directions by the cosine law about n, one in each cell of a side x side grid over the unit square.
struct Fan {
    Vec3 a, b, n;
    int side;
    uint32_t state;
    Fan(Vec3 normal, int side, uint32_t seed) : n(normal), side(side), state(pcg(seed)) {
        a = normalize(cross(std::fabs(n.y) < 0.9f ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, n));
        b = cross(n, a);
    }
    Vec3 direction(int k) {
        float u = ((float)(k % side) + random(state)) / (float)side,
              v = ((float)(k / side) + random(state)) / (float)side, r = std::sqrt(u), t = v * 6.2831853f;
        return a * (r * std::cos(t)) + b * (r * std::sin(t)) + n * std::sqrt(std::max(0.f, 1 - u));
    }
};

} // namespace

int castFan(const Scene &scene, const Chart &from, Vec3 p, int side, uint32_t seed,
            const std::function<void(int chart, Vec3 at, Vec3 d)> &met) {
    Fan fan(from.n, side, seed);
    Ray8 ray;
    int backs = 0;
    ray.o = broadcast(p + from.n * from.off());
    for (int first = 0; first < side * side; first += 8) {
        int count = std::min(8, side * side - first);
        for (int k = 0; k < 8; ++k) {
            Vec3 d = k < count ? fan.direction(first + k) : from.n;
            ray.d.x[k] = d.x, ray.d.y[k] = d.y, ray.d.z[k] = d.z;
        }
        Hit8 hit = intersect(scene, ray, kLanes < count);
        // A back in front of it is black
        Float8 open = transmittance(scene, ray, min(hit.t, kFar) * 0.9999f, kLanes < count, broadcast(-1)).y;
        for (int k = 0; k < count; ++k) {
            backs += open[k] <= 0.5f;
            if (open[k] <= 0.5f) continue;
            Vec3 d = {ray.d.x[k], ray.d.y[k], ray.d.z[k]};
            if (hit.shape[k] < 0)
                met(-1, {}, d);
            else
                met(scene.shapes[hit.shape[k]].chart, p + d * hit.t[k], d);
        }
    }
    return backs;
}

std::vector<Probe> placeProbes(const Model &m, int count) {
    double area = 0;
    for (int i = 0; i < m.chartCount; ++i)
        if (!m.charts[i].open) area += (double)m.charts[i].width * (double)m.charts[i].height;
    std::vector<Probe> probes;
    uint32_t state = 1;
    double due = 0;
    for (int i = 0; i < m.chartCount; ++i) {
        const Chart &c = m.charts[i];
        if (c.open) continue;
        for (due += (double)c.width * (double)c.height / area * count; due >= 1; --due)
            for (int tries = 0; tries < 20; ++tries) {
                float u = random(state) * c.width, v = random(state) * c.height;
                bool there = false;
                for (int f = c.firstFacet; f < c.firstFacet + c.facetsCount; ++f)
                    there |= onFacet(m.facets[f], {u, v});
                // What touches hidden places is left out: nobody sees it
                const Cell &cell = cellAt(m, c, {u, v});
                for (int k = 0; k < 4; ++k) there &= m.texels[cell.corner[k]].visible >> (3 - k) & 1;
                if (!there) continue;
                probes.push_back({i, c.at(u, v), {}, false});
                break;
            }
    }
    return probes;
}

Rgb lightAtProbe(const Model &m, float *const light[3], const Probe &probe) {
    Lightmap map = {};
    map.charts = m.charts;
    map.cells = m.cells;
    for (int k = 0; k < 3; ++k) map.plane[k] = light[k];
    Rgb8 l = lightAt(map, m.charts[probe.chart], broadcast(probe.p));
    return {l.x[0], l.y[0], l.z[0]};
}

double rmsPercent(const Model &m, float *const light[3], const std::vector<Probe> &probes) {
    double error = 0, all = 0;
    for (const Probe &probe : probes) {
        Rgb d = lightAtProbe(m, light, probe) - probe.light, l = probe.light;
        error += (double)(d.x * d.x + d.y * d.y + d.z * d.z);
        all += (double)(l.x * l.x + l.y * l.y + l.z * l.z);
    }
    return 100 * std::sqrt(error / all);
}

double facetFormFactor(const Model &m, const Scene &scene, int facet, const Chart &from, Vec3 p, int side,
                       uint32_t seed) {
    const Facet &f = m.facets[facet];
    const Chart &lamp = m.charts[f.chart];
    Vec3 q = f.corner(lamp, 0), u = f.corner(lamp, 1) - q, v = f.corner(lamp, f.triangle() ? 2 : 3) - q;
    double area = (double)length(cross(u, v)) * (f.triangle() ? 0.5 : 1), factor = 0;
    uint32_t state = pcg(seed * 7919u + 1);
    for (int first = 0; first < side * side; first += 8) {
        Ray8 ray = {broadcast(p + from.n * from.off()), {}};
        Float8 far, kernel;
        for (int k = 0; k < 8; ++k) {
            int i = (first + k) % side, j = (first + k) / side;
            float s = ((float)i + random(state)) / (float)side, t = ((float)j + random(state)) / (float)side;
            if (f.triangle() && s + t > 1) s = 1 - s, t = 1 - t;
            Vec3 to = q + u * s + v * t - p;
            float d = length(to);
            to = to * (1 / d);
            far[k] = d * 0.9999f;
            kernel[k] = std::max(0.f, dot(to, from.n)) * std::max(0.f, -dot(to, lamp.n)) / (d * d);
            ray.d.x[k] = to.x, ray.d.y[k] = to.y, ray.d.z[k] = to.z;
        }
        Int8 active = (kernel > 0.f) & (kLanes < side * side - first);
        if (!any(active)) continue;
        Float8 open = transmittance(scene, ray, far, active, broadcast(-1)).y;
        for (int k = 0; k < 8; ++k)
            if (active[k]) factor += (double)(kernel[k] * open[k]);
    }
    return factor * area / (M_PI * side * side);
}

void gatherProbes(const Bake &b, std::vector<Probe> &probes, int side, Workers &workers) {
    const Model &m = *b.model;
    parallelFor(workers, (int)probes.size(), [&](int index, int) {
        Probe &probe = probes[(size_t)index];
        const Chart &c = m.charts[probe.chart];
        double sum[3] = {};
        auto add = [&](Rgb l) { sum[0] += (double)l.x, sum[1] += (double)l.y, sum[2] += (double)l.z; };
        // Lamps of very many facets are met by the same rays
        bool many = b.glows.size() > 64;
        int backs = castFan(*b.scene, c, probe.p, side, (uint32_t)index, [&](int chart, Vec3 at, Vec3) {
            if (chart < 0) return;
            add(lightAtProbe(m, b.light, {chart, at, {}, false}) * b.reflects(chart));
            if (many) add(b.emits(chart));
        });
        probe.inside = backs > side * side / 20;
        for (double &s : sum) s /= side * side;
        for (const Glow &g : b.glows) {
            if (many) break;
            add(g.radiance * (float)facetFormFactor(m, *b.scene, g.facet, c, probe.p, side, (uint32_t)index));
        }
        probe.light = {(float)sum[0], (float)sum[1], (float)sum[2]};
    });
    dropInside(probes);
}

void dropInside(std::vector<Probe> &probes) {
    std::erase_if(probes, [](const Probe &p) { return p.inside; });
}

RowFinder rowsByRays(int side) {
    return [side](const Model &m, const Scene &scene, const uint8_t *lit, Workers &workers, Arena &arena,
                  FormFactors &factors, const Progress &) {
        std::vector<FoundRow> rows((size_t)m.patchCount);
        parallelFor(workers, m.patchCount, [&](int i, int) {
            const Patch &p = m.patches[i];
            if (p.share == 0 || !lit[i]) return;
            std::vector<uint32_t> met;
            castFan(scene, m.charts[p.chart], p.p, side, (uint32_t)i, [&](int chart, Vec3 at, Vec3) {
                if (chart >= 0) met.push_back(patchAt(m, chart, at));
            });
            std::sort(met.begin(), met.end());
            FoundRow &found = rows[(size_t)i];
            for (size_t k = 0; k < met.size();) {
                size_t end = k;
                while (end < met.size() && met[end] == met[k]) ++end;
                if (lit[met[k]]) found.links.push_back({met[k], (float)(end - k) / (float)(side * side)});
                k = end;
            }
            found.known = true;
        });
        keepRows(rows, arena, factors);
        return !workers.aborted();
    };
}

} // namespace odraz
