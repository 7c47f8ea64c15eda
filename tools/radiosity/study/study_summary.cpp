// What to choose, and why; what was left out.
#include "tools/radiosity/study/study.h"

#include <algorithm>
#include <cmath>

namespace odraz {

void writeSummary(Study &study) {
    Page &page = study.page;
    page.toFront();
    page.text(study.settings.model + ": " + std::to_string(study.mesh.triangles.size()) + " triangles, " +
              std::to_string(study.reference.charts.size()) +
              " polygons in one plane each. Errors are against a reference, a solution by rays " +
              (study.finalRays ? "with a final gather of " + std::to_string(study.finalRays) + " rays"
                               : std::string("without a final gather, for which there was no time")) +
              ", which shares neither hemicubes nor patches with what is measured here, at 2000 places "
              "spread by area. "
              "rms is the root mean square of the differences in luminance as a share of that of the "
              "reference's light.");
    std::vector<MeasuredSolution> all = study.measured;
    std::sort(all.begin(), all.end(), [](auto &a, auto &b) { return a.seconds < b.seconds; });
    PageTable table = {"solutions",
                       {"solution", "processor_s", "wall_s", "rms_percent", "median_percent", "options"},
                       {"solution", "processor, s", "clock, s", "error (rms), %", "median, %",
                        "options of radiosity solve"}};
    // Of what was measured, those that nothing beats in both time and error
    double least = INFINITY;
    const MeasuredSolution *cheapest = nullptr;
    PageTable front = table;
    for (const MeasuredSolution &m : all) {
        std::vector<std::string> row = {
            m.name, shown(m.seconds), shown(m.wall), shown(m.errors.rms), shown(m.errors.median), m.options};
        table.rows.push_back(row);
        if (!(m.errors.rms < least)) continue;
        least = m.errors.rms;
        front.rows.push_back(row);
        if (!cheapest && m.errors.rms <= study.settings.within) cheapest = &m;
    }
    page.heading("What to choose");
    std::vector<std::string> advice;
    if (cheapest)
        advice.push_back("The cheapest solution within " + shown(study.settings.within) +
                         " %: " + cheapest->name + ": " + shown(cheapest->errors.rms) + " % off after " +
                         shown(cheapest->seconds) + " s (radiosity solve " + cheapest->options + ").");
    else if (std::isfinite(least))
        advice.push_back("No solution that was measured is within " + shown(study.settings.within) +
                         " %; the best is " + shown(least) + " % off.");
    advice.insert(advice.end(), study.advice.begin(), study.advice.end());
    page.list(advice);
    if (!front.rows.empty()) {
        page.text("Solutions that nothing beats in both time and error:");
        front.file = "front";
        page.table(front);
        page.text("All solutions that were measured:");
        page.table(table, false);
    }
    if (!study.leftOut.empty()) {
        page.text("Left out, because " + shown(study.settings.minutes) +
                  " minutes do not allow it (--minutes):");
        page.list(study.leftOut);
    }
    if (!study.notes.empty()) {
        page.text("Notes on the model:");
        page.list(study.notes);
    }
}

} // namespace odraz
