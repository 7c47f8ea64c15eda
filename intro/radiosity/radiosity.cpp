#include "radiosity/radiosity.h"

#include "radiosity/spread.h"
#include "radiosity/ties.h"

namespace odraz {

static bool takePlanes(Radiosity &r, Arena &arena, size_t texels) {
    size_t padded = texels + 8;
    for (int k = 0; k < r.bases.count(); ++k) {
        for (float *&plane : r.bounced[k]) plane = arena.allocate<float>(padded);
        r.direct[k] = arena.allocate<float>(padded);
    }
    return !arena.full;
}

// Makes the system for all bases, whose light is white. The direct light of a patch is the mean of its
// texels. A hidden patch, of which others may see a margin, gets its neighbours' light and a neighbour's row.
// Returns false if the arena is full.
static bool fillSystem(Radiosity &r, const Model &model, Arena &arena, Workers &workers) {
    System &s = r.system;
    int bases = r.bases.count();
    if (!makeSystem(s, arena, r.factors, model.patchCount, 3 * bases)) return false;
    size_t columns = (size_t)s.columns;
    for (int i = 0; i < model.patchCount; ++i) {
        Rgb reflects = model.patches[i].reflects;
        float *to = s.reflectance + (size_t)i * columns;
        for (int k = 0; k < bases; ++k)
            to[3 * k] = reflects.x, to[3 * k + 1] = reflects.y, to[3 * k + 2] = reflects.z;
    }
    parallelFor(workers, bases, [&](int k, int) {
        float *to = s.direct + 3 * k;
        meansOfPatches(model, r.direct[k], to, s.columns);
        for (int i = 0; i < model.patchCount; ++i, to += columns) to[1] = to[2] = to[0];
    });
    fillPatches(model, r.factors, s.columns, s.direct, 0, model.patchCount);
    return true;
}

// Adds the indirect light of the system to the planes of its columns.
static void spreadLight(Radiosity &r, const Model &model, Workers &workers) {
    const System &s = r.system;
    fillPatches(model, r.factors, s.columns, s.indirect, 0, model.patchCount);
    addToTexels(model, s.indirect, s.columns, r.bounced[0], 3 * r.bases.count(), workers,
                3 * r.bases.skyCount);
}

// Adds direct light of the skies to their bounced light, and applies the ties to all planes.
static void finishLight(Radiosity &r, const Model &model, Workers &workers) {
    parallelFor(workers, r.bases.count(), [&](int k, int) {
        for (float *plane : r.bounced[k]) {
            for (int t = 0; t < model.texelCount && k < r.bases.skyCount; ++t) plane[t] += r.direct[k][t];
            applyTies(model, plane);
        }
        applyTies(model, r.direct[k]);
    });
}

bool solveRadiosity(Radiosity &r, Model &model, Scene &scene, const RadiositySettings &settings,
                    const SolverHost &host) {
    auto &[method, gl, arena, workers, progress] = host;
    if (!model.divide(arena, settings.block) || !takePlanes(r, arena, (size_t)model.texelCount)) return false;
    findVisible(model, scene, workers);
    model.placePatches();
    progress(0.05f);

    r.factors.capacity = settings.links;
    r.factors.links = arena.allocate<Link>(settings.links);
    if (arena.full || !method.open(r.hemicubes, gl, scene, arena, settings.px)) return false;
    for (int i = 0; i < model.patchCount; ++i) {
        Patch &p = model.patches[i];
        const Chart &c = model.charts[p.chart];
        if (!c.open) p.reflects = scene.mean[c.material];
    }
    if (!findFormFactors(method, r.hemicubes, model, workers, arena, r.factors, progress.part(0.05f, 0.635f)))
        return false;

    findDirectLight(model, scene, r.bases, workers, r.direct, progress.part(0.635f, 0.92f));
    tie(model);
    progress(0.92f);
    if (workers.aborted() || !fillSystem(r, model, arena, workers)) return false;
    solve(r.system, workers, settings.residual, settings.sweeps);
    progress(0.965f);
    findIndirect(r.system, workers);
    spreadLight(r, model, workers);
    finishLight(r, model, workers);
    progress(1);
    return !workers.aborted();
}

} // namespace odraz
