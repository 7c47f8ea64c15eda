// Measures sizes by rasters, each solved by shooting with hemicubes: the thesis's Table 4.1 for any model.
#include "tools/common/text.h"
#include "tools/radiosity/study/study.h"

#include <algorithm>

namespace odraz::radiosity {

namespace {

constexpr int kSizes[] = {1500, 6000, 24000}, kShots = 8000, kQuickShots = 2000;

// The thesis's minutes: Athlon X2 4600+, GeForce 7600 GT, 7 passes with a hemicube at each triangle.
constexpr int kThesisSizes[] = {26360, 136512, 546048}, kThesisRasters[] = {100, 200, 500};
constexpr double kThesisMinutes[3][3] = {{4.667, 8.75, 39.667}, {58.333, 81.667, 233}, {583, 700, 1516}};

// Solves every size with every raster.
void fill(Study &study, bool ofThesis, PageTable &table, pictures::Plot &plot) {
    const int count = study.settings.quick ? 2 : 3, shots = study.settings.quick ? kQuickShots : kShots;
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column) {
            int px = kThesisRasters[column];
            const SolveReport r = study.measure((ofThesis ? kThesisSizes : kSizes)[row], px, shots).report;
            const MeasuredSolution &m = study.measured.back();
            double secondsPerShot = r.seconds[(int)SolveStep::kSolving] / std::max(r.shots, 1);
            const std::string patches = common::counted((size_t)r.patches, "patch");
            table.rows.push_back({std::to_string(r.patches), std::to_string(px), std::to_string(r.shots),
                                  shown(m.seconds), shown(m.wall), shown(1000 * secondsPerShot),
                                  shown(100 * (double)r.residual, 2), shown(m.errors.rms),
                                  shown(m.errors.median), shown(secondsPerShot * r.patches / 60, 2)});
            if (ofThesis) {
                table.rows.back().push_back(shown(kThesisMinutes[row][column], 4));
                // Print each when it is done, because these take long
                study.print(patches + " by " + std::to_string(px) +
                            " pixels: " + common::counted((size_t)r.shots, "shot") + ", " + shown(m.wall) +
                            " s (processor " + shown(m.seconds) + " s), error " + shown(m.errors.rms) + " %");
            }
            if (column == 0) plot.series.push_back(patches);
            plot.points.push_back({m.seconds, m.errors.rms, std::to_string(px), false, row});
        }
}

} // namespace

void studyTable(Study &study, bool ofThesis) {
    Page &page = study.page;
    page.heading(ofThesis ? "The thesis's Table 4.1" : "Sizes by rasters");
    page.text(
        "Each patch is one element, which receives light. Blocks of patches shoot it, the brightest first, "
        "each through a hemicube at one of its patches, until 0.5 % of the light is unshot, or for a number "
        "of shots that is the same for all. The remaining light is then spread evenly; if much remains, it "
        "causes most of the error. Otherwise most of it lies in corners, where surfaces meet: the light of a "
        "block lands there as the one patch sees it, in spots that smaller patches resolve, so that more "
        "patches may have a larger rms error while the median falls. Hemicubes see the lamps. The last time "
        "is an estimate for one hemicube at "
        "every patch, which gathering needs. The thesis draws all of these again in every pass.");
    PageTable table = {"table",
                       {"patches", "px", "shots", "processor_s", "wall_s", "ms_per_shot", "unshot_percent",
                        "rms_percent", "median_percent", "every_patch_min"},
                       {"patches", "pixels", "shots", "processor, s", "clock, s", "processor, ms a shot",
                        "not shot, %", "error (rms), %", "median, %", "every patch, processor min"}};
    if (ofThesis) table.columns.push_back("thesis_min"), table.heads.push_back("thesis, min");
    pictures::Plot plot = errorPlot("light that is shot: error against time, a mark for each raster",
                                    "processor time, s", "error (rms), %");
    plot.joined = true;
    auto finish = [&] {
        if (table.rows.empty()) return;
        page.table(table);
        page.plot("table", plot);
    };
    try {
        fill(study, ofThesis, table, plot);
    } catch (const Interrupted &) {
        // Keep what was measured, because it takes long
        finish();
        page.keep();
        throw;
    }
    finish();
}

} // namespace odraz::radiosity
