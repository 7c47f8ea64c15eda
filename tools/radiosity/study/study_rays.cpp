// The settings of solving by rays, each changed alone.
#include "tools/radiosity/study/study.h"

#include <algorithm>

namespace odraz::radiosity {

void studyRays(Study &study) {
    Page &page = study.page;
    page.heading("Rays, lamp samples, elements and a final gather");
    page.text(
        "The default of radiosity solve, which sends rays from every element, with one setting changed. "
        "The last two errors are against path tracing, without its noise.");
    pictures::Plot plot = errorPlot("by rays: error against time", "processor time, s",
                                    "error (rms) against path tracing, %", {"one setting changed"});
    PageTable table = {
        "rays",
        {"setting", "elements", "processor_s", "rms_percent", "paths_rms_percent", "paths_median_percent"},
        {"setting", "elements", "processor, s", "error (rms), %", "against paths (rms), %",
         "against paths (median), %"}};
    struct Setting {
        const char *option;
        double value;
    };
    double longest = 0;
    for (auto [option, value] : {Setting{"--rays", 16},
                                 {"--rays", 64},
                                 {"--lamp-samples", 1},
                                 {"--element", study.area / 7500},
                                 {"--rays", 256},
                                 {"--lamp-samples", 64},
                                 {"--element", study.area / 120000},
                                 {"--final", 256}}) {
        std::string name = std::string(option) + " " + shown(value, 6);
        if (!study.fits(longest)) {
            study.leftOut.push_back("rays: " + name);
            continue;
        }
        SolveSettings s = study.settings.solve;
        if (option == std::string("--rays")) s.rays = (int)value;
        if (option == std::string("--lamp-samples")) s.lampSamples = (int)value;
        if (option == std::string("--element")) s.element = value;
        if (option == std::string("--final")) s.finalRays = (int)value;
        Solved solved = study.measure("by rays, " + name, name, s);
        const MeasuredSolution &m = study.measured.back();
        longest = std::max(longest, 1.5 * m.wall);
        solvedAt(solved.solution, study.traced);
        MeshErrors paths = errorsOf(study.traced);
        table.rows.push_back({name, std::to_string(solved.solution.elements()), shown(m.seconds),
                              shown(m.errors.rms), shown(paths.rms), shown(paths.median)});
        plot.points.push_back({m.seconds, paths.rms, name, false, 0});
    }
    if (table.rows.empty()) return;
    page.table(table);
    page.plot("rays", plot);
}

} // namespace odraz::radiosity
