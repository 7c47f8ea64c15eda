#include "tools/radiosity/patches/row_finder.h"

#include "tools/radiosity/solution/memory.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

// Estimates the number of links in all rows from those of at least 64 patches spread over the model, with a
// reserve.
size_t estimateLinks(AnyHemicubes &hemicubes, const Model &m, const uint8_t *lit, Workers &workers) {
    const auto batch = (size_t)hemicubes.h.batch;
    auto hasRow = [&](int i) { return lit[i] && m.patches[i].share > 0; };
    std::vector<Eye> eyes;
    size_t rows = 0, links = 0, seen = 0;
    for (int i = 0; i < m.patchCount; ++i) rows += hasRow(i);
    size_t every = std::max((size_t)1, rows / std::max(batch, (size_t)64));
    for (int i = 0; i < m.patchCount; ++i)
        if (hasRow(i) && seen++ % every == 0)
            eyes.push_back(hemicubeEye(m.patches[i].p, m.patches[i].n, (uint32_t)i));
    if (eyes.empty()) return 1;
    for (size_t first = 0; first < eyes.size(); first += batch)
        for (const std::vector<float> &row :
             hemicubes.rows(m, std::span(eyes).subspan(first, std::min(batch, eyes.size() - first)), workers))
            for (int i = 0; i < m.patchCount; ++i) links += row[(size_t)i] > 0 && lit[i];
    return links * rows / eyes.size() * 5 / 4 + 1000;
}

// Adds the known rows to those drawn so far, and passes progress on.
struct Merging {
    const Model &m;
    FormFactors &factors;
    const Row *before; // null: none
    const Progress &heard;

    void merge() const {
        for (int i = 0; before && i < m.patchCount; ++i)
            if (before[i].known) factors.rows[i] = before[i];
    }
    Progress progress() {
        return {[](float done, void *p) {
                    ((Merging *)p)->merge();
                    ((Merging *)p)->heard(done);
                },
                this};
    }
};

} // namespace

RowFinder rowsByHemicubes(const Gl &gl, int px, int each, EyeOf eyeOf) {
    return [&gl, px, each, eyeOf](const Model &m, const Scene &, const uint8_t *lit, Workers &workers,
                                  Arena &arena, FormFactors &factors, const Progress &progress) {
        AnyHemicubes hemicubes(gl, px);
        // Known rows are not drawn again, but the others have links to their patches
        const Row *before = factors.rows;
        std::vector<uint8_t> missing(lit, lit + m.patchCount);
        size_t had = 0;
        for (int i = 0; before && i < m.patchCount; ++i)
            if (before[i].known) missing[(size_t)i] = kShines, had += (size_t)before[i].count;
        // Allow for the memory of later stages
        size_t all = estimateLinks(hemicubes, m, lit, workers) * (size_t)each,
               links = all - std::min(all, had),
               rest = (size_t)m.patchCount * (kHemicubeBatch * 4 + 400) + (size_t)m.texelCount * 40 +
                      AnyHemicubes::bytesFor(px),
               needed = links * sizeof(Link) + rest;
        if (arena.used + needed > arena.size) refuseMemory(arena, needed);
        factors.links = takeOrRefuse<Link>(arena, links);
        factors.capacity = links;
        hemicubes.h.turns = each;
        int step = (int)(m.patchCount * 0.6180339) | 1;
        while (std::gcd(step, m.patchCount) != 1) step += 2;
        Merging merging = {m, factors, before, progress};
        Progress merged = merging.progress();
        bool done =
            px % 2 || eyeOf
                ? findRowsFrom(hemicubes, m, missing.data(), workers, arena, factors, merged, step, eyeOf)
                : findFormFactors(hemicubes.h, m, missing.data(), workers, arena, factors, merged, step);
        if (factors.rows) merging.merge();
        if (!done && !workers.aborted())
            throw std::runtime_error("the rows took more memory than estimated: raise --memory");
        return done;
    };
}

} // namespace odraz::radiosity
