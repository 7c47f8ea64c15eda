
#include "tools/radiosity/study/gathering.h"

#include "base/random.h"
#include "tools/radiosity/patches/row_finder.h"
#include "tools/radiosity/rays/light_grid.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

RowFinder rowsByRays(int rays, bool atCorners) {
    return [rays, atCorners](const Model &m, const Scene &, const uint8_t *lit, Workers &workers,
                             Arena &arena, FormFactors &factors, const Progress &progress) {
        std::vector<int> chartOf;
        RayTree tree(cornersOf({m.facets, (size_t)m.facetCount}, m.charts, chartOf));
        std::vector<FoundRow> rows((size_t)m.patchCount);
        parallelRanges(workers, m.patchCount, 64, [&](int first, int end, int) {
            std::vector<uint32_t> hits;
            for (int i = first; i < end; ++i) {
                const Patch &p = m.patches[i];
                const Chart &c = m.charts[p.chart];
                rows[(size_t)i].known = p.share > 0 && lit[i] == kReflects;
                if (!rows[(size_t)i].known) continue;
                hits.clear();
                // The golden angle on a disc, rotated differently at every patch
                float begin = unitFloat(pcg((uint32_t)i));
                for (int k = 0; k < rays; ++k) {
                    float out = std::sqrt(((float)k + 0.5f) / (float)rays), up = std::sqrt(1 - out * out),
                          turn = 2.3999632f * (float)k + begin * 6.2831853f;
                    Vec3 d = c.u * (out * std::cos(turn)) + c.v * (out * std::sin(turn)) + c.n * up,
                         from = (atCorners ? cornerEye(m, i, k & 3).p : p.p) + c.n * c.off();
                    RayHit hit = tree.nearest(from, d);
                    if (hit.triangle < 0 || hit.back) continue;
                    uint32_t j = patchAt(m, chartOf[(size_t)hit.triangle], from + d * hit.t);
                    if (lit[j] != kUnlit) hits.push_back(j);
                }
                std::sort(hits.begin(), hits.end());
                std::vector<Link> &links = rows[(size_t)i].links;
                for (uint32_t j : hits) {
                    if (links.empty() || links.back().patch != j) links.push_back({j, 0});
                    links.back().share += 1 / (float)rays;
                }
            }
        });
        if (workers.aborted()) return false;
        keepRows(rows, arena, factors);
        progress(1);
        return true;
    };
}

} // namespace odraz::radiosity
