#include "tools/measure/oracle/reference.h"

#include "tools/radiosity/divide/facets.h"
#include "tools/radiosity/patches/row_finder.h"

#include <algorithm>
#include <cmath>

namespace odraz {

using namespace radiosity;

std::vector<Probe> placeProbes(const Model &m, int count) {
    double area = 0;
    for (int i = 0; i < m.chartCount; ++i)
        if (!m.charts[i].open) area += (double)m.charts[i].width * (double)m.charts[i].height;
    std::vector<Probe> probes;
    Sampler sampler(1);
    double due = 0;
    for (int i = 0; i < m.chartCount; ++i) {
        const Chart &c = m.charts[i];
        if (c.open) continue;
        for (due += (double)c.width * (double)c.height / area * count; due >= 1; --due)
            for (int tries = 0; tries < 20; ++tries) {
                float u = (float)sampler.random() * c.width, v = (float)sampler.random() * c.height;
                bool there = false;
                for (int f = c.firstFacet; f < c.firstFacet + c.facetsCount; ++f)
                    there |= onFacet(m.facets[f], {u, v});
                // Leave out cells that touch hidden places: nobody sees them
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

void traceProbes(const Solved &solved, std::vector<Probe> &probes, int side, Workers &workers) {
    const PatchSystem &b = *solved.patches;
    const Model &m = *b.model;
    ModelRays rays(m);
    parallelFor(workers, (int)probes.size(), [&](int index, int) {
        Probe &probe = probes[(size_t)index];
        const Chart &c = m.charts[probe.chart];
        Vec3d sum = {};
        // If a model has very many lamp facets, the same rays look for them
        bool many = b.glows.size() > 64;
        int backs = rays.castFan(c, probe.p, side, (uint32_t)index, [&](int chart, Vec3 at, Vec3) {
            if (chart < 0) return;
            sum = sum + toDouble(lightAtProbe(m, b.light, {chart, at, {}, false}) *
                                 solved.solution.reflects[(size_t)chart]);
            if (many) sum = sum + toDouble(solved.solution.emits[(size_t)chart]);
        });
        probe.inside = insideBy(backs, side);
        probe.light = toFloat(sum / (side * side));
        for (const Glow &g : b.glows) {
            if (many) break;
            probe.light +=
                g.radiance * (float)rays.facetFormFactor(g.facet, c, probe.p, side, (uint32_t)index);
        }
    });
    dropInside(probes);
}

bool insideBy(int backs, int side) { return backs > side * side / 20; }

void dropInside(std::vector<Probe> &probes) {
    std::erase_if(probes, [](const Probe &p) { return p.inside; });
}

} // namespace odraz
