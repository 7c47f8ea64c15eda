#include "tools/radiosity/patches/patch_rows.h"

#include "tools/common/clock.h"
#include "tools/radiosity/patches/row_finder.h"
#include "tools/radiosity/solution/arrays.h"
#include "tools/radiosity/solution/memory.h"

#include <algorithm>

namespace odraz::radiosity {

namespace {

constexpr int kMissing = -1; // a row's count if the row is unknown

// Loads saved rows. Links are used in place if they are aligned. Throws std::runtime_error.
void restore(SolveTask &task, PatchSystem &p) {
    std::string_view resumed = task.settings.resumed;
    task.settings.resumed = {};
    auto count = (size_t)p.model->patchCount;
    size_t at = 0, used = 0;
    std::vector<int32_t> counts;
    std::vector<Link> copied;
    std::span<const Link> links;
    bool good = get(resumed, at, counts) && counts.size() == count;
    if (good && !getWhereItLies(resumed, at, links)) {
        good = get(resumed, at, copied);
        Link *to = takeOrRefuse<Link>(p.arena, copied.size());
        std::copy(copied.begin(), copied.end(), to);
        links = {to, copied.size()};
    }
    for (size_t i = 0; good && i < count; ++i) {
        good = counts[i] >= kMissing && counts[i] <= p.model->patchCount;
        used += (size_t)std::max(counts[i], 0);
    }
    uint32_t largest = 0;
    for (const Link &l : links) largest = std::max(largest, l.patch);
    if (!good || at != resumed.size() || used != links.size() || largest >= count) refuseResumed();
    FormFactors &f = p.radiosity.factors;
    f.rows = takeOrRefuse<Row>(p.arena, count);
    const Link *next = links.data();
    for (size_t i = 0; i < count; ++i)
        if (counts[i] != kMissing) {
            f.rows[i] = {next, counts[i], true};
            next += counts[i];
        }
}

// Marks each patch whose row is needed: it reflects, or emits light that hemicubes find.
const uint8_t *findLit(const SolveTask &task, PatchSystem &p) {
    const Model &m = *p.model;
    auto *lit = takeOrRefuse<uint8_t>(p.arena, (size_t)m.patchCount);
    for (int i = 0; i < m.patchCount; ++i) {
        const Patch &patch = m.patches[i];
        bool seen = !task.settings.analytic && maxComponent(task.solution.emits[(size_t)patch.chart]) > 0;
        // With other materials, any patch may reflect
        lit[i] = maxComponent(patch.reflects) > 0 || seen || task.settings.keepRows ? kReflects : kUnlit;
    }
    return lit;
}

// Reports progress, and saves rows at intervals.
struct Watch {
    const SolveTask &task;
    const PatchSystem &patches;
    double kept; // when rows were last saved

    Progress progress() {
        return {[](float done, void *own) { ((Watch *)own)->hear(done); }, this};
    }
    void hear(float done) {
        task.show(SolveStep::kFormFactors, done);
        if (common::wallSeconds() - kept < task.settings.keepEvery) return;
        keepPatchRows(task, patches);
        kept = common::wallSeconds();
    }
};

} // namespace

std::string savedPatchRows(const PatchSystem &p) {
    std::vector<int32_t> counts;
    std::vector<Link> links;
    for (int i = 0; i < p.model->patchCount; ++i) {
        const Row &row = p.radiosity.factors.rows[i];
        counts.push_back(row.known ? row.count : kMissing);
        if (row.known) links.insert(links.end(), row.links, row.links + row.count);
    }
    std::string rows;
    put(rows, counts), put(rows, links);
    return rows;
}

void keepPatchRows(const SolveTask &task, const PatchSystem &p) {
    if (task.settings.keep) task.settings.keep(savedPatchRows(p));
}

void findPatchRows(SolveTask &task, PatchSystem &p, const Gl &gl) {
    const SolveSettings &s = task.settings;
    const uint8_t *lit = findLit(task, p);
    if (!s.resumed.empty()) restore(task, p);
    auto count = [&] {
        for (int i = 0; i < p.model->patchCount; ++i) task.report.rows += p.radiosity.factors.rows[i].known;
    };
    if (task.prepared) { // nothing is missing
        task.report.whole = true;
        return count();
    }
    RowFinder find = s.findRows;
    if (!find) find = rowsByHemicubes(gl, s.hemicube, s.turns, s.turn);
    Watch watch = {task, p, common::wallSeconds()};
    const int *abort = task.workers.abort;
    task.workers.abort = task.stop;
    task.report.whole =
        find(*p.model, *p.scene, lit, task.workers, p.arena, p.radiosity.factors, watch.progress());
    task.workers.abort = abort;
    if (!task.report.whole) keepPatchRows(task, p);
    count();
}

} // namespace odraz::radiosity
