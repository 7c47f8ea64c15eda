// Direct light separated by material, for solutions with other power of the lamps.
#include "tools/radiosity/patches/patch_solver.h"

#include <algorithm>

namespace odraz::radiosity {

void PatchSolver::findShares() {
    DirectShares &kept = shares;
    kept.emitters = task.emitters();
    kept.seen = !s.analytic;
    if (kept.seen) return;
    auto texels = (size_t)m.texelCount;
    if (kept.emitters.size() == 1) { // all light comes from that material
        Rgb e = task.emitted()[(size_t)kept.emitters[0]];
        int k = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
        kept.shares.emplace_back(r.direct[k], r.direct[k] + texels);
        for (float &share : kept.shares[0]) share /= maxComponent(e);
        return;
    }
    std::vector<int> materialOf;
    for (const Glow &g : p.glows)
        materialOf.push_back(task.regions.material[(size_t)m.facets[g.facet].chart]);
    std::vector<float> planes[3];
    float *to[3];
    // Do three materials at a time, as red, green and blue
    for (size_t first = 0; first < kept.emitters.size(); first += 3) {
        size_t end = std::min(first + 3, kept.emitters.size());
        std::vector<Glow> glows;
        for (size_t i = 0; i < p.glows.size(); ++i)
            for (size_t k = first; k < end; ++k) {
                if (kept.emitters[k] != materialOf[i]) continue;
                glows.push_back(p.glows[i]);
                glows.back().radiance = {k == first ? 1.f : 0.f, k == first + 1 ? 1.f : 0.f,
                                         k == first + 2 ? 1.f : 0.f};
            }
        LightBases bases = {};
        bases.skyCount = 3, bases.glows = glows.data(), bases.glowCount = (int)glows.size();
        for (int k = 0; k < 3; ++k) planes[k].assign(texels + 8, 0), to[k] = planes[k].data();
        for (int t = 0; t < m.texelCount; ++t) m.fresh[t] = t;
        m.freshCount = m.texelCount;
        odraz::findDirectLight(m, *p.scene, bases, task.workers, to, {});
        m.freshCount = 0;
        for (size_t k = first; k < end; ++k)
            kept.shares.emplace_back(planes[k - first].begin(), planes[k - first].begin() + m.texelCount);
    }
}

void PatchSolver::findOutsideShare() {
    if (!s.surroundings.any()) return;
    shares.outside = shares.light(task.emitted(), (size_t)m.texelCount);
    for (size_t t = 0; t < shares.outside.size(); ++t)
        shares.outside[t] = Rgb{r.direct[0][t], r.direct[1][t], r.direct[2][t]} - shares.outside[t];
}

} // namespace odraz::radiosity
