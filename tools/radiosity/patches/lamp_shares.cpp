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
    std::vector<float> planes[3];
    float *to[3];
    kept.find([&](const std::vector<Rgb> &ofMaterial) {
        std::vector<Glow> glows;
        for (const Glow &g : p.glows) {
            Rgb radiance = ofMaterial[(size_t)task.regions.material[(size_t)m.facets[g.facet].chart]];
            if (maxComponent(radiance) > 0) glows.push_back({g.facet, g.cells, radiance});
        }
        LightBases bases = {};
        bases.skyCount = 3, bases.glows = glows.data(), bases.glowCount = (int)glows.size();
        for (int k = 0; k < 3; ++k) planes[k].assign(texels + 8, 0), to[k] = planes[k].data();
        for (int t = 0; t < m.texelCount; ++t) m.fresh[t] = t;
        m.freshCount = m.texelCount;
        odraz::findDirectLight(m, *p.scene, bases, task.workers, to, {});
        m.freshCount = 0;
        std::vector<Rgb> light;
        for (size_t t = 0; t < texels; ++t) light.push_back({to[0][t], to[1][t], to[2][t]});
        return light;
    });
}

void PatchSolver::findOutsideShare() {
    if (!s.surroundings.any()) return;
    shares.outside = shares.light(task.emitted(), (size_t)m.texelCount);
    for (size_t t = 0; t < shares.outside.size(); ++t)
        shares.outside[t] = Rgb{r.direct[0][t], r.direct[1][t], r.direct[2][t]} - shares.outside[t];
}

} // namespace odraz::radiosity
