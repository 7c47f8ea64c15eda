#include "tools/radiosity/solve/solve_report.h"

#include <cstdio>

namespace odraz::radiosity {

static void printSweeps(const SolveReport &r, const SolveSettings &settings) {
    if (settings.bounces >= 0)
        std::printf("%d bounces\n", r.sweeps);
    else
        std::printf("%d sweeps, residual %.1e\n", r.sweeps, (double)r.residual);
}

void printReport(const Mesh &mesh, const Solved &solved, const SolveSettings &settings) {
    const SolveReport &r = solved.report;
    bool byRays = !solved.patches;
    auto seconds = [&](SolveStep step) { return r.seconds[(int)step]; };
    std::printf("%zu triangles, %zu polygons in one plane each; ", mesh.triangles.size(),
                solved.solution.charts.size());
    size_t elements = solved.solution.elements();
    if (byRays)
        std::printf("%zu elements, %d sites with %zu rays\n", elements, r.sites, r.raysFromSite);
    else
        std::printf("%d patches, %zu elements\n", r.patches, elements);
    std::printf("processor seconds: dividing %.2f, form factors %.2f", seconds(SolveStep::kDividing),
                seconds(SolveStep::kFormFactors));
    if (!byRays) std::printf(" (%d hemicubes)", r.rows + r.shots);
    std::printf(", direct light %.2f, solving %.2f\n", seconds(SolveStep::kDirectLight),
                seconds(SolveStep::kSolving));
    if (r.lamps > kManyLamps) std::printf("%zu lamps: seen by hemicubes\n", r.lamps);
    if (r.shots > 0)
        std::printf("%d shots, %.2g %% of the light is not shot%s\n", r.shots, 100 * (double)r.residual,
                    r.whole ? "" : ": stopped");
    else if (!r.whole && r.sweeps > 0)
        std::printf("stopped: the light of %d sweeps\n", r.sweeps);
    else if (!r.whole)
        std::printf("stopped: direct light, and the rows of %d %s\n", r.rows, byRays ? "sites" : "patches");
    else
        printSweeps(r, settings);
}

void printRelit(const Solved &solved, const SolveSettings &settings) {
    const SolveReport &r = solved.report;
    auto seconds = [&](SolveStep step) { return r.seconds[(int)step]; };
    if (solved.patches)
        std::printf("kept rows of %d patches\n", r.patches);
    else
        std::printf("kept rows of %d sites with %zu rays\n", r.sites, r.raysFromSite);
    std::printf("processor seconds: reading %.2f, solving %.2f\n",
                seconds(SolveStep::kDividing) + seconds(SolveStep::kFormFactors),
                seconds(SolveStep::kDirectLight) + seconds(SolveStep::kSolving));
    if (!r.whole)
        std::printf("stopped: the light of %d sweeps\n", r.sweeps);
    else
        printSweeps(r, settings);
}

} // namespace odraz::radiosity
