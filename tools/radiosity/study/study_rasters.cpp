// Compares rasters from 25 to 800 pixels, and anti-aliasing and corners with more pixels.
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/study/gathering.h"

#include <cmath>
#include <span>

namespace odraz::radiosity {

namespace {

constexpr int kRasters[] = {25, 50, 100, 200, 400, 800}, kPatches = 1500;

std::span<const int> rasters(const Study &study) {
    return std::span(kRasters).first(study.settings.quick ? 4 : std::size(kRasters));
}

// The layouts of a patch's hemicubes that are compared.
constexpr const char *kLayouts[] = {"one in the middle", "four rotated differently", "four near the corners"};

struct TriedLayout {
    int px, layout;
    Gathering::Result result;
};

void gatherAt(Study &study, Gathering &gathering) {
    std::vector<TriedLayout> tried;
    for (int px : rasters(study))
        for (int layout = 0; layout < 3; ++layout) {
            // Four hemicubes of half the side have the same number of pixels
            int each = layout ? px / 2 : px;
            tried.push_back({each, layout, gathering.measure(each, layout ? 4 : 1, layout == 2)});
        }
    // The effect of the raster alone: the difference from the finest raster, of hemicubes in the middle
    const TriedLayout &finest = tried[tried.size() - 3];
    PageTable table = {
        "gathering",
        {"hemicubes", "px", "processor_ms_per_patch", "rms_percent", "median_percent", "from_finest_percent"},
        {"hemicubes of a patch", "pixels", "ms a patch", "error (rms), %", "median, %",
         "from the finest (rms), %"}};
    pictures::Plot plot =
        errorPlot("one gather: the error of the raster alone, against time", "processor time of a patch, ms",
                  "difference from the finest raster (rms), %", {kLayouts[0], kLayouts[1]});
    for (const TriedLayout &t : tried) {
        const MeshErrors &e = t.result.errors;
        bool compared = t.layout < 2 && &t != &finest;
        double ms = 1000 * t.result.seconds,
               fromFinest = compared ? errorsOf(t.result.light, finest.result.light).rms : NAN;
        table.rows.push_back({kLayouts[t.layout], std::to_string(t.px), shown(ms), shown(e.rms),
                              shown(e.median), shown(fromFinest)});
        if (t.layout < 2) plot.points.push_back({ms, fromFinest, std::to_string(t.px), false, t.layout});
    }
    study.page.table(table);
    study.page.plot("gathering", plot);
}

// Measures whole solutions, and shows their pictures.
void solveAt(Study &study, Gathering &gathering) {
    Page &page = study.page;
    PageTable table = {"rasters",
                       {"px", "patches", "processor_s", "wall_s", "rms_percent", "median_percent"},
                       {"pixels", "patches", "processor, s", "clock, s", "error (rms), %", "median, %"}};
    std::vector<PagePicture> pictures, hemicubes;
    RenderSettings camera = study.camera();
    camera.logarithmic = true;
    int widest = gathering.patchSeeingMost();
    for (int px : rasters(study)) {
        std::string name = std::to_string(px);
        if (widest >= 0) {
            std::string file = "hemicube-" + name + ".png";
            pictures::writePng(page.path(file), gathering.unfolded(widest, px));
            hemicubes.push_back({file, "the view of one patch, " + name + " pixels"});
        }
        Solved solved = study.measure(kPatches, px);
        const MeasuredSolution &m = study.measured.back();
        table.rows.push_back({name, std::to_string(solved.report.patches), shown(m.seconds), shown(m.wall),
                              shown(m.errors.rms), shown(m.errors.median)});
        std::string file = "raster-" + name + ".png";
        render(solved.solution, camera, study.workers, page.path(file));
        pictures.push_back(
            {file, name + " pixels: error " + shown(m.errors.rms) + " %, " + shown(m.seconds) + " s"});
    }
    page.pictures(hemicubes);
    page.text("Whole solutions, with a hemicube for every patch. The half faces of an odd raster have half a "
              "row more.");
    page.table(table);
    page.pictures(pictures);
}

} // namespace

void studyRasters(Study &study) {
    Page &page = study.page;
    page.heading("Rasters from 25 to " + std::to_string(rasters(study).back()) + " pixels");
    SolveSettings s = study.thesis(kPatches, 16);
    s.bounces = s.each = 0; // only divides the model
    Solved divided = study.solve(s);
    Gathering gathering(study, divided, study.settings.quick ? 150 : 600);
    page.text(
        "First, one gather: " + std::to_string(gathering.count()) + " patches of " +
        std::to_string(divided.patches->model->patchCount) +
        " gather the light of the reference, lamps included. The error against the reference has "
        "two causes: the raster, and patches that have one light value each. The plot shows only the first, "
        "as the difference from the finest raster. Four hemicubes of half the size are anti-aliasing with "
        "the same number of samples; four at the corners show the error of one hemicube in the middle.");
    gatherAt(study, gathering);
    solveAt(study, gathering);
}

} // namespace odraz::radiosity
