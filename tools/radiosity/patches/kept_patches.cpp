#include "tools/radiosity/patches/kept_patches.h"

#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>

namespace odraz::radiosity {

namespace {

struct KeptPatches {
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<Patch> patches;
    std::vector<Tie> ties;

    bool get(std::string_view from) {
        size_t at = 0;
        return radiosity::get(from, at, cells) && radiosity::get(from, at, texels) &&
               radiosity::get(from, at, patches) && radiosity::get(from, at, ties) && at == from.size();
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
template <class T> std::vector<T> list(const T *first, int count) { return {first, first + count}; }

} // namespace

void savePatches(const Model &m, std::string &to) {
    put(to, list(m.cells, m.cellCount)), put(to, list(m.texels, m.texelCount));
    put(to, list(m.patches, m.patchCount)), put(to, list(m.ties, m.tieCount));
}

void restorePatches(const PreparedSolve &prepared, const Regions &regions, PatchSystem &p) {
    KeptPatches kept;
    if (!kept.get(prepared.rest) || !kept.fits(regions) || !prepared.direct.fits(kept.texels.size()))
        refuseResumed();
    Model &m = *p.model;
    fillModel(m, regions);
    m.cellRoom = m.cellCount = fill(p.arena, m.cells, kept.cells);
    m.texelRoom = m.texelCount = fill(p.arena, m.texels, kept.texels);
    m.patchCount = fill(p.arena, m.patches, kept.patches);
    m.tieRoom = m.tieCount = fill(p.arena, m.ties, kept.ties);
}

} // namespace odraz::radiosity
