// Patches, elements and rows as arrays of files.
#include "tools/radiosity/patches/patch_solver.h"

#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>
#include <utility>

namespace odraz::radiosity {

namespace {

constexpr int kMissing = -1; // a row's count if the row is unknown

struct KeptPatches {
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Patch> patches;
    std::vector<Tie> ties;

    bool get(std::string_view from) {
        size_t at = 0;
        return radiosity::get(from, at, cells, texels, patches, ties) && at == from.size();
    }
    // Whether every index lies within its list. A checksum is not enough, because a forger can compute it.
    bool fits(const Regions &regions) const {
        auto all = [](const auto &list, auto good) { return std::all_of(list.begin(), list.end(), good); };
        auto within = [](int i, size_t count) { return i >= 0 && (size_t)i < count; };
        return validGeometry(regions.charts, regions.facets, cells, texels) &&
               all(regions.charts,
                   [&](const Chart &c) {
                       return c.patchesAcross > 0 && c.patchesDown > 0 && c.patchesAcross <= c.across &&
                              c.patchesDown <= c.down && c.firstPatch >= 0 &&
                              (size_t)c.firstPatch + (size_t)c.patchesAcross * (size_t)c.patchesDown <=
                                  patches.size();
                   }) &&
               all(cells, [&](const Cell &c) { return within(c.patch, patches.size()); }) &&
               all(patches, [&](const Patch &p) { return within(p.chart, regions.charts.size()); }) &&
               all(ties, [&](const Tie &t) {
                   return within(t.texel, texels.size()) && within(t.towards, texels.size());
               });
    }
};

template <class T> int fill(Arena &arena, T *&to, const std::vector<T> &from) {
    to = takeOrRefuse<T>(arena, from.size());
    std::copy(from.begin(), from.end(), to);
    return (int)from.size();
}
template <class T> std::span<const T> list(const T *first, int count) { return {first, (size_t)count}; }

} // namespace

void PatchSolver::savePatches(std::string &to) const {
    put(to, list(m.cells, m.cellCount), list(m.texels, m.texelCount), list(m.patches, m.patchCount),
        list(m.ties, m.tieCount));
}

void PatchSolver::restorePatches() {
    const PreparedSolve &prepared = *task.prepared;
    KeptPatches kept;
    if (!kept.get(prepared.rest) || !kept.fits(task.regions) || !prepared.direct.fits(kept.texels.size()))
        refuseResumed();
    fillModel(m, task.regions);
    m.cellRoom = m.cellCount = fill(p.arena, m.cells, kept.cells);
    m.texelRoom = m.texelCount = fill(p.arena, m.texels, kept.texels);
    m.patchCount = fill(p.arena, m.patches, kept.patches);
    m.tieRoom = m.tieCount = fill(p.arena, m.ties, kept.ties);
}

// The links are used in place. Throws std::runtime_error.
void PatchSolver::restoreRows() {
    std::string_view resumed = std::exchange(s.resumed, {});
    auto count = (size_t)m.patchCount;
    size_t at = 0, used = 0;
    std::vector<int32_t> counts;
    std::span<const Link> links;
    bool good = get(resumed, at, counts, links) && counts.size() == count;
    for (size_t i = 0; good && i < count; ++i) {
        good = counts[i] >= kMissing && counts[i] <= m.patchCount;
        used += (size_t)std::max(counts[i], 0);
    }
    uint32_t largest = 0;
    for (const Link &l : links) largest = std::max(largest, l.patch);
    if (!good || at != resumed.size() || used != links.size() || largest >= count) refuseResumed();
    r.factors.rows = takeOrRefuse<Row>(p.arena, count);
    const Link *next = links.data();
    for (size_t i = 0; i < count; ++i)
        if (counts[i] != kMissing) {
            r.factors.rows[i] = {next, counts[i], true};
            next += counts[i];
        }
}

std::string PatchSolver::savedRows() const {
    std::vector<int32_t> counts;
    std::vector<Link> links;
    for (int i = 0; i < m.patchCount; ++i) {
        const Row &row = r.factors.rows[i];
        counts.push_back(row.known ? row.count : kMissing);
        if (row.known) links.insert(links.end(), row.links, row.links + row.count);
    }
    std::string rows;
    put(rows, counts, links);
    return rows;
}

void PatchSolver::saveState() const {
    if (s.keep) s.keep(savedRows());
}

} // namespace odraz::radiosity
