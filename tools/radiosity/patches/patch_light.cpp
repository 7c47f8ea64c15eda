#include "tools/radiosity/patches/patch_solver.h"

#include "tools/common/text.h"
#include "tools/radiosity/solution/memory.h"

namespace odraz::radiosity {

void PatchSolver::findLights() {
    p.glows = findLamps(task.mesh, task.regions, m, s.lampSamples);
    report.lamps = p.glows.size();
    const Surroundings &around = s.surroundings;
    if (around.suns.size() > (size_t)kMaxSuns || around.lamps.size() > (size_t)kMaxLamps)
        throw ModelError(common::format("there are %zu suns and %zu lamps; between patches at most %d and %d",
                                        around.suns.size(), around.lamps.size(), kMaxSuns, kMaxLamps));
    if (p.glows.size() > kManyLamps) s.analytic = false;
    r.bases.skyCount = 3;
    // Suns and lamps are separate bases until their direct light is found
    Vec3 middle = toFloat(task.mesh.middle());
    float far = (float)(1000 * task.mesh.size());
    for (const Sun &sun : around.suns) r.bases.suns[r.bases.sunCount++] = middle + sun.towards * far;
    for (const BallLamp &lamp : around.lamps)
        r.bases.lamps[r.bases.lampCount++] = {lamp.centre, lamp.radius, -1};
    if (!s.analytic) return;
    r.bases.glows = p.glows.data();
    r.bases.glowCount = (int)p.glows.size();
}

void PatchSolver::findDirectLight() {
    RadiositySettings settings;
    settings.levels = s.adaptive ? kDivided : 0;
    settings.contrast = 0.05f;
    takePlanes();
    findDirect(r, m, *p.scene, settings, task.workers, progressOf(SolveStep::kDirectLight));
    std::vector<std::string> known; // notes by divide()
    if (s.adaptive) findPictured(known);
    addOutsideLight();
}

void PatchSolver::takePlanes() {
    size_t texels = (size_t)m.texelRoom + 8;
    for (int k = 3; k < r.bases.count(); ++k) r.direct[k] = takeOrRefuse<float>(p.arena, texels);
    for (int k = 0; k < 3; ++k) {
        r.direct[k] = takeOrRefuse<float>(p.arena, texels);
        p.light[k] = takeOrRefuse<float>(p.arena, texels);
        float *unused = takeOrRefuse<float>(p.arena, texels);
        for (int c = 0; c < 3; ++c) r.bounced[k][c] = k == c ? p.light[k] : unused;
    }
}

void PatchSolver::addOutsideLight() {
    const Surroundings &around = s.surroundings;
    auto add = [&](int basis, const Rgb &light) {
        const float share[3] = {light.x, light.y, light.z};
        for (int k = 0; k < 3; ++k)
            for (int t = 0; t < m.texelCount; ++t) r.direct[k][t] += share[k] * r.direct[basis][t];
    };
    for (size_t i = 0; i < around.suns.size(); ++i) add(r.bases.firstSun() + (int)i, around.suns[i].light);
    for (size_t i = 0; i < around.lamps.size(); ++i)
        add(r.bases.firstLamp() + (int)i, around.lamps[i].radiance);
    r.bases.sunCount = r.bases.lampCount = 0;
    if (around.sky.width) addSky();
}

} // namespace odraz::radiosity
