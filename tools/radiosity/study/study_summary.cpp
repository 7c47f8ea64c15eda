// Summarizes a study: the reference and its errors, and the best of all solutions.
#include "tools/common/text.h"
#include "tools/radiosity/study/study.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

void writeSummary(Study &study) {
    Page &page = study.page;
    page.toFront();
    page.text(
        study.settings.model + ": " + common::counted(study.mesh.triangles.size(), "triangle") + ", " +
        common::counted(study.reference.charts.size(), "polygon") +
        " in one plane each. Errors are against a reference, a solution by rays with a final gather of " +
        std::to_string(study.settings.finalRays()) +
        " rays, at 2000 places spread by area. It has neither hemicubes nor patches. The rms error is the "
        "root mean square of the differences in luminance, as a share of the reference's.");
    page.text(study.referenceText);
    std::vector<MeasuredSolution> all = study.measured;
    std::sort(all.begin(), all.end(), [](auto &a, auto &b) { return a.seconds < b.seconds; });
    PageTable table = {"solutions",
                       {"solution", "processor_s", "wall_s", "rms_percent", "median_percent", "command"},
                       {"solution", "processor, s", "clock, s", "error (rms), %", "median, %", "command"}};
    // Find the solutions that no other one beats in both time and error
    double least = INFINITY;
    PageTable front = table;
    for (const MeasuredSolution &m : all) {
        std::vector<std::string> row = {
            m.name, shown(m.seconds), shown(m.wall), shown(m.errors.rms), shown(m.errors.median), m.command};
        table.rows.push_back(row);
        if (!(m.errors.rms < least)) continue;
        least = m.errors.rms;
        front.rows.push_back(row);
    }
    page.heading("The best settings");
    if (!front.rows.empty()) {
        page.text("Settings of radiosity solve that no other one beats in both time and error:");
        front.file = "front";
        page.table(front);
        page.text("All solutions that chapters compare by time:");
        page.table(table, false);
    }
    if (!study.leftOut.empty()) {
        page.text("Left out, because the study was interrupted:");
        page.list(study.leftOut);
    }
    if (!study.notes.empty()) {
        page.text("Notes on the model:");
        page.list(study.notes);
    }
}

} // namespace odraz::radiosity
