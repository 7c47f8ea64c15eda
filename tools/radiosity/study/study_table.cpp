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

struct TableCell {
    MeasuredSolution measured;
    SolveReport report;
};

std::vector<std::string> rowOf(const TableCell &c, int px) {
    const MeasuredSolution &m = c.measured;
    const SolveReport &r = c.report;
    double secondsPerShot = r.seconds[(int)SolveStep::kSolving] / std::max(r.shots, 1);
    return {std::to_string(r.patches),
            std::to_string(px),
            std::to_string(r.shots),
            shown(m.seconds),
            shown(m.wall),
            shown(1000 * secondsPerShot),
            shown(100 * (double)r.residual, 2),
            shown(m.errors.rms),
            shown(m.errors.median),
            shown(secondsPerShot * r.patches / 60, 2)};
}

TableCell shoot(Study &study, int patches, int px, int shots) {
    SolveSettings s = study.thesis(patches, px);
    s.shots = shots;
    s.residual = 0.005f;
    std::string options = "--direct hemicube --hemicube " + std::to_string(px) + " --patch " +
                          shown(s.patch, 6) + " --element " + shown(s.element, 6) + " --shots " +
                          std::to_string(shots) + " --residual 0.005";
    Solved solved = study.measure("shot by " + std::to_string(px) + " px", options, s);
    return {study.measured.back(), std::move(solved.report)};
}

class Table {
public:
    Table(Study &study, bool ofThesis) : study(study), ofThesis(ofThesis) {
        if (ofThesis) table.columns.push_back("thesis_min"), table.heads.push_back("thesis, min");
        plot.joined = true;
    }

    void fill() {
        const int count = study.settings.quick ? 2 : 3;
        for (int row = 0; row < count; ++row)
            for (int column = 0; column < count; ++column) fillCell(row, column);
    }
    void finish() {
        if (table.rows.empty()) return;
        study.page.table(table);
        study.page.plot("table", plot);
    }

private:
    Study &study;
    bool ofThesis;
    PageTable table = {"table",
                       {"patches", "px", "shots", "processor_s", "wall_s", "ms_per_shot", "unshot_percent",
                        "rms_percent", "median_percent", "every_patch_min"},
                       {"patches", "pixels", "shots", "processor, s", "clock, s", "processor, ms a shot",
                        "not shot, %", "error (rms), %", "median, %", "every patch, processor min"}};
    pictures::Plot plot = errorPlot("light that is shot: error against time, a mark for each raster",
                                    "processor time, s", "error (rms), %");
    int lastRow = -1; // the last row that has a cell

    void fillCell(int row, int column) {
        int px = kThesisRasters[column];
        TableCell cell = shoot(study, (ofThesis ? kThesisSizes : kSizes)[row], px,
                               study.settings.quick ? kQuickShots : kShots);
        const MeasuredSolution &m = cell.measured;
        const std::string patches = common::counted((size_t)cell.report.patches, "patch");
        if (ofThesis) // print each when it is done, because these take long
            study.print(patches + " by " + std::to_string(px) + " pixels: " +
                        common::counted((size_t)cell.report.shots, "shot") + ", " + shown(m.wall) +
                        " s (processor " + shown(m.seconds) + " s), error " + shown(m.errors.rms) + " %");
        table.rows.push_back(rowOf(cell, px));
        if (ofThesis) table.rows.back().push_back(shown(kThesisMinutes[row][column], 4));
        if (row != lastRow) plot.series.push_back(patches);
        lastRow = row;
        plot.points.push_back(
            {m.seconds, m.errors.rms, std::to_string(px), false, (int)plot.series.size() - 1});
    }
};

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
    Table table(study, ofThesis);
    try {
        table.fill();
    } catch (const Interrupted &) {
        // Keep what was measured, because it takes long
        table.finish();
        page.keep();
        throw;
    }
    table.finish();
}

} // namespace odraz::radiosity
