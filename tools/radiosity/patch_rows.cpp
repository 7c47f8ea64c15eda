#include "tools/radiosity/patch_rows.h"

#include "tools/common/clock.h"
#include "tools/radiosity/arrays.h"

#include <algorithm>

namespace odraz {

namespace {

constexpr int kMissing = -1; // as a row's count: it is not known

// Takes up the rows that were kept. Throws std::runtime_error.
void restore(Bake &b) {
    auto count = (size_t)b.model->patchCount;
    size_t at = 0, used = 0;
    std::vector<int32_t> counts;
    std::vector<Link> links;
    bool good = get(b.settings.resumed, at, counts) && get(b.settings.resumed, at, links) &&
                at == b.settings.resumed.size() && counts.size() == count;
    for (size_t i = 0; good && i < count; ++i) {
        good = counts[i] >= kMissing && counts[i] <= b.model->patchCount;
        used += (size_t)std::max(counts[i], 0);
    }
    good = good && used == links.size() &&
           std::all_of(links.begin(), links.end(), [&](const Link &l) { return l.patch < count; });
    if (!good) refuseKept();
    b.settings.resumed.clear();
    FormFactors &f = b.radiosity.factors;
    f.rows = takeOrRefuse<Row>(b.arena, count);
    Link *next = takeOrRefuse<Link>(b.arena, links.size());
    std::copy(links.begin(), links.end(), next);
    for (size_t i = 0; i < count; ++i)
        if (counts[i] != kMissing) {
            f.rows[i] = {next, counts[i], true};
            next += counts[i];
        }
}

} // namespace

void keepPatchRows(const Bake &b) {
    if (!b.settings.keep) return;
    std::vector<int32_t> counts;
    std::vector<Link> links;
    for (int i = 0; i < b.model->patchCount; ++i) {
        const Row &row = b.radiosity.factors.rows[i];
        counts.push_back(row.known ? row.count : kMissing);
        if (row.known) links.insert(links.end(), row.links, row.links + row.count);
    }
    std::string rows;
    put(rows, counts), put(rows, links);
    b.settings.keep(rows);
}

void findPatchRows(Bake &b, const Gl &gl, Workers &workers, const int *stop, const Told &told) {
    const Model &m = *b.model;
    const BakeSettings &s = b.settings;
    auto *lit = takeOrRefuse<uint8_t>(b.arena, (size_t)m.patchCount);
    for (int i = 0; i < m.patchCount; ++i) {
        const Patch &p = m.patches[i];
        // Lamps too where hemicubes are to see them
        bool seen = !s.analytic && maxComponent(b.emits(p.chart)) > 0;
        lit[i] = maxComponent(p.reflects) > 0 || seen ? kReflects : kUnlit;
    }
    if (!s.resumed.empty()) restore(b);
    RowFinder find = s.rows;
    if (!find) find = rowsByHemicubes(gl, s.hemicube, s.turns, s.turn);
    struct Watch {
        const Bake &b;
        const Told &told;
        double kept;
    } watch = {b, told, wallSeconds()};
    Progress progress = {[](float done, void *p) {
                             Watch &w = *(Watch *)p;
                             if (w.told) w.told(Bake::kSteps[1], done, -1);
                             if (wallSeconds() - w.kept < w.b.settings.keepEvery) return;
                             keepPatchRows(w.b);
                             w.kept = wallSeconds();
                         },
                         &watch};
    const int *watched = workers.abort;
    workers.abort = stop;
    b.whole = find(m, *b.scene, lit, workers, b.arena, b.radiosity.factors, progress);
    workers.abort = watched;
    if (!b.whole) keepPatchRows(b);
    for (int i = 0; i < m.patchCount; ++i) b.rows += b.radiosity.factors.rows[i].known;
}

} // namespace odraz
