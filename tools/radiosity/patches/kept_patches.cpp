// Rows as arrays of files.
#include "tools/radiosity/patches/patch_solver.h"

#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>
#include <utility>

namespace odraz::radiosity {

static constexpr int kMissing = -1; // a row's count if the row is unknown

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

void PatchSolver::saveState() const {
    if (!s.keep) return;
    std::vector<int32_t> counts;
    std::vector<Link> links;
    for (int i = 0; i < m.patchCount; ++i) {
        const Row &row = r.factors.rows[i];
        counts.push_back(row.known ? row.count : kMissing);
        if (row.known) links.insert(links.end(), row.links, row.links + row.count);
    }
    std::string rows;
    put(rows, counts, links);
    s.keep(rows);
}

} // namespace odraz::radiosity
