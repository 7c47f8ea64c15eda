#include "radiosity/radiosity.h"

namespace odraz {

static bool takePlanes(Radiosity &r, Arena &arena, size_t texels) {
    size_t padded = texels + 8;
    for (int k = 0; k < r.lights.bases(); ++k) {
        for (float *&plane : r.bounced[k])
            if (!(plane = arena.take<float>(padded))) return false;
        if (!(r.direct[k] = arena.take<float>(padded))) return false;
    }
    return true;
}

// Patches reflect what arrives: the mean of their texels' direct light.
static void fillSystem(Radiosity &r, const Model &model, const Scene &scene, Workers &workers) {
    const Lights &lights = r.lights;
    System &s = r.system;
    size_t columns = (size_t)s.columns;
    for (int i = 0; i < model.patchCount; ++i) {
        const Chart &c = model.charts[model.patches[i].chart];
        Rgb mean = c.open ? Rgb{} : scene.mean[c.material];
        float *to = s.reflectance + (size_t)i * columns;
        for (int k = 0; k < lights.bases(); ++k)
            to[3 * k] = mean.x, to[3 * k + 1] = mean.y, to[3 * k + 2] = mean.z;
    }
    parallelFor(workers, lights.bases(), [&](int k, int) {
        float *to = s.direct + 3 * k;
        meansOfPatches(model, r.direct[k], to, s.columns);
        for (size_t i = 0; i < (size_t)model.patchCount; ++i, to += columns) to[1] = to[2] = to[0];
    });
}

// Divides the cells over which the light of some basis changes much, and looks at what is new.
static void refineAll(Radiosity &r, Model &model, const Scene &scene, const RadiositySettings &settings,
                      Workers &workers) {
    // Of the skies the first one tells
    Measure measures[kMaxBases];
    int count = 0;
    for (int k = 0; k < r.lights.bases() && settings.levels; ++k)
        if ((k == 0 || k >= r.lights.skyCount) && !(settings.traced >> k & 1))
            count += measure(model, r.direct[k], settings.contrast, measures[count]);
    for (int level = 0; level < settings.levels; ++level) {
        refine(model, level, measures, count, settings.contrast);
        findVisible(model, scene, workers);
        findDirectLight(model, scene, r.lights, workers, r.direct, {});
        settleFresh(model);
    }
}

bool solveRadiosity(Radiosity &r, Model &model, Scene &scene, const RadiositySettings &settings, const Gl &gl,
                    Arena &arena, Workers &workers, const Progress &progress) {
    // Divide, and see what is hidden
    if (!model.divide(scene, arena, workers, settings.block, settings.levels) ||
        !takePlanes(r, arena, (size_t)model.texelRoom))
        return false;
    progress(0.05f);

    // Form factors
    auto *lit = arena.take<uint8_t>((size_t)model.patchCount);
    r.factors.capacity = settings.links;
    r.factors.links = arena.take<Link>(settings.links);
    if (!lit || !r.factors.links || !openHemicubes(r.hemicubes, gl, arena, settings.px)) return false;
    for (int i = 0; i < model.patchCount; ++i) {
        const Chart &c = model.charts[model.patches[i].chart];
        lit[i] = !c.open && maxComponent(scene.mean[c.material]) > 0 ? kReflects : kShines;
    }
    if (!findFormFactors(r.hemicubes, model, lit, workers, arena, r.factors, progress.part(0.05f, 0.635f)))
        return false;

    // Direct light
    findDirectLight(model, scene, r.lights, workers, r.direct, progress.part(0.635f, 0.8f));
    progress(0.8f);
    settleFresh(model);
    refineAll(r, model, scene, settings, workers);
    tie(model);
    progress(0.92f);
    if (workers.aborted()) return false;

    // Bounces, brought to the elements
    if (!makeSystem(r.system, arena, r.factors, model.patchCount, 3 * r.lights.bases())) return false;
    float *gathered = arena.take<float>((size_t)model.patchCount * (size_t)r.system.columns);
    if (!gathered) return false;
    fillSystem(r, model, scene, workers);
    solve(r.system, workers, settings.residual, settings.sweeps);
    progress(0.965f);
    gather(r.factors, model.patchCount, r.system.columns, r.system.radiosity, gathered, workers);
    fillPatches(model, r.factors, r.system.columns, gathered, 0, model.patchCount);
    addToTexels(model, gathered, r.system.columns, r.bounced[0], 3 * r.lights.bases(), workers,
                3 * r.lights.skyCount);
    parallelFor(workers, r.lights.bases(), [&](int k, int) {
        for (float *plane : r.bounced[k]) {
            for (int t = 0; t < model.texelCount && k < r.lights.skyCount; ++t) plane[t] += r.direct[k][t];
            settle(model, plane);
        }
        settle(model, r.direct[k]);
    });
    progress(1);
    return !workers.aborted();
}

} // namespace odraz
