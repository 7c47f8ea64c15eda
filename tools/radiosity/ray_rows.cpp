#include "tools/radiosity/ray_rows.h"

#include "trace/rays/intersect.h"

#include <algorithm>

namespace odraz {

namespace {

// The direction of a hemicube's pixel, in its frame.
Vec3 pixelDirection(int px, int pixel) {
    int line = pixel / px;
    float a = ((float)(pixel % px) + 0.5f) * 2 / (float)px - 1;
    if (line < px) return {a, ((float)line + 0.5f) * 2 / (float)px - 1, 1};
    int side = (line - px) / (px / 2);
    float up = ((float)((line - px) % (px / 2)) + 0.5f) * 2 / (float)px;
    return side == 0   ? Vec3{1, a, up}
           : side == 1 ? Vec3{-a, 1, up}
           : side == 2 ? Vec3{-1, -a, up}
                       : Vec3{a, -1, up};
}

// The hemicube of a patch: the numbers of its pixels.
std::vector<uint32_t> lookAround(const Model &m, const Scene &scene, int patch, int px) {
    const Patch &p = m.patches[patch];
    const Chart &c = m.charts[p.chart];
    Eye eye = hemicubeEye(p.p, p.n, (uint32_t)patch);
    std::vector<uint32_t> ids((size_t)(3 * px * px));
    Ray8 ray;
    ray.o = broadcast(p.p + c.n * c.off());
    for (int first = 0; first < 3 * px * px; first += 8) {
        int lanes = std::min(8, 3 * px * px - first);
        for (int k = 0; k < 8; ++k) {
            Vec3 local = pixelDirection(px, first + std::min(k, lanes - 1));
            Vec3 d = normalize(transposeTimes(eye.frame, local));
            ray.d.x[k] = d.x, ray.d.y[k] = d.y, ray.d.z[k] = d.z;
        }
        Int8 active = kLanes < lanes;
        Hit8 hit = intersect(scene, ray, active);
        // Fronts alone stop a ray, both sides stop light: what it does not reach is behind a back
        Float8 open = broadcast(1.f);
        if (!m.solid) open = transmittance(scene, ray, min(hit.t, kFar) * 0.9999f, active, broadcast(-1)).y;
        for (int k = 0; k < lanes; ++k) {
            uint32_t &id = ids[(size_t)(first + k)];
            Vec3 d = {ray.d.x[k], ray.d.y[k], ray.d.z[k]};
            if (open[k] <= 0.5f)
                id = kBackSide;
            else if (hit.shape[k] >= 0)
                id = patchAt(m, scene.shapes[hit.shape[k]].chart, p.p + d * hit.t[k]) + 1;
        }
    }
    return ids;
}

} // namespace

RowFinder rowsByRayHemicubes(int px) {
    return [px](const Model &m, const Scene &scene, const uint8_t *lit, Workers &workers, Arena &arena,
                FormFactors &factors, const Progress &progress) {
        size_t count = (size_t)m.patchCount;
        std::vector<float> delta((size_t)(3 * px * px)), sums((size_t)(3 * px * (px + 1)));
        deltaFormFactors(px, delta.data());
        accumulateFormFactors(px, delta.data(), sums.data());
        std::vector<FoundRow> rows(count);
        int done = 0;
        parallelFor(workers, m.patchCount, [&](int i, int worker) {
            if (worker == 0) progress((float)__atomic_load_n(&done, __ATOMIC_RELAXED) / (float)count);
            __atomic_add_fetch(&done, 1, __ATOMIC_RELAXED);
            if (m.patches[i].share == 0 || !lit[i]) return;
            std::vector<uint32_t> ids = lookAround(m, scene, i, px);
            Hemicubes h = {};
            h.px = px, h.columns = 1, h.ids = ids.data();
            std::vector<float> row(count);
            sumHemicube(h, 0, sums.data(), row.data());
            FoundRow &found = rows[(size_t)i];
            for (size_t k = 0; k < count; ++k)
                if (row[k] > 0 && lit[k]) found.links.push_back({(uint32_t)k, row[k]});
            found.known = true;
        });
        keepRows(rows, arena, factors);
        return !workers.aborted();
    };
}

bool seesBacks(const Model &m, const Scene &scene, Workers &workers) {
    static constexpr int kPlaces = 500, kPx = 6;
    int every = std::max(1, m.patchCount / kPlaces), backs = 0;
    parallelFor(workers, (m.patchCount + every - 1) / every, [&](int i, int) {
        if (m.patches[i * every].share == 0) return;
        std::vector<uint32_t> ids = lookAround(m, scene, i * every, kPx);
        int seen = (int)std::count(ids.begin(), ids.end(), kBackSide);
        __atomic_add_fetch(&backs, seen, __ATOMIC_RELAXED);
    });
    return backs > 0;
}

} // namespace odraz
