// Rasters from 25 to 800 pixels; anti-aliasing and corners against more pixels.
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/study/gathering.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odraz {

namespace {

constexpr int kRasters[] = {25, 50, 100, 200, 400, 800};

void gatherAt(Study &study, Gathering &gathering, double patches, double until) {
    PageTable table = {"gathering",
                       {"hemicubes", "px", "processor_ms_per_patch", "rms_percent", "median_percent"},
                       {"hemicubes of a patch", "pixels", "ms a patch", "error (rms), %", "median, %"}};
    Plot plot = {"one gather: error against time",
                 "processor time of a patch, ms",
                 "error (rms), %",
                 {"one in the middle", "four turned differently", "four near the corners"},
                 {},
                 true,
                 true};
    plot.frontOfEach = true;
    struct Found {
        std::string name;
        double ms, rms;
    };
    std::vector<Found> found;
    for (int px : kRasters)
        for (int series = 0; series < 3; ++series) {
            // Four of half the pixels have as many in total
            int of = series ? px / 2 : px;
            if (of < 12) continue;
            double more = found.empty() ? 0 : found.back().ms / 1000 * patches * 4;
            if (study.left() < until || more > study.left() - until) {
                study.leftOut.push_back("one gather: " + std::to_string(of) + " pixels, " +
                                        plot.series[(size_t)series]);
                continue;
            }
            Gathering::Result r = gathering.measure({of, series == 1 ? 4 : 1, series == 2});
            double ms = 1000 * r.seconds;
            table.rows.push_back({plot.series[(size_t)series], std::to_string(of), shown(ms),
                                  shown(r.errors.rms), shown(r.errors.median)});
            plot.points.push_back({ms, r.errors.rms, std::to_string(of), false, series});
            found.push_back(
                {plot.series[(size_t)series] + ", of " + std::to_string(of) + " pixels", ms, r.errors.rms});
        }
    study.page.table(table);
    study.page.plot("gathering", plot);
    if (found.empty()) return;
    // The cheapest within a fifth of what a whole solution may be off; if none is, within a tenth of the best
    double least = INFINITY;
    for (const Found &f : found) least = std::min(least, f.rms);
    double allowed = std::max(study.settings.within / 5, 1.1 * least);
    const Found *choice = nullptr;
    for (const Found &f : found)
        if (f.rms <= allowed && (!choice || f.ms < choice->ms)) choice = &f;
    if (choice)
        study.advice.push_back("Hemicubes: " + choice->name + ": " + shown(choice->rms) + " % off for " +
                               shown(choice->ms) + " ms a patch, the cheapest within " + shown(allowed) +
                               " %; the least error that was measured is " + shown(least) + " %.");
}

// Whole solutions, with pictures.
void solveAt(Study &study, int asked, Gathering &gathering) {
    Page &page = study.page;
    PageTable table = {"rasters",
                       {"px", "patches", "processor_s", "wall_s", "rms_percent", "median_percent"},
                       {"pixels", "patches", "processor, s", "clock, s", "error (rms), %", "median, %"}};
    std::vector<PagePicture> pictures, seen;
    RenderSettings camera;
    camera.width = 360, camera.height = 270, camera.logarithmic = true;
    camera.upIsZ = study.settings.upIsZ;
    placeCamera(study.reference, camera);
    int curious = gathering.curious();
    for (int px : kRasters) {
        std::string name = std::to_string(px);
        if (curious >= 0) {
            std::string file = "hemicube-" + name + ".png";
            if (!writePng(page.path(file), gathering.unfolded(curious, px)))
                throw std::runtime_error("cannot write " + page.path(file));
            seen.push_back({file, "what one patch sees, " + name + " pixels"});
        }
        if (!study.fits(1.3 * study.patchesFor(asked) * study.hemicubeSeconds(px) + study.divideSeconds())) {
            study.leftOut.push_back("rasters: a whole solution with " + name + " pixels");
            continue;
        }
        SolveSettings s = study.thesis(asked, px);
        Solved b = study.measure("gathered by " + name + " px",
                                 "--direct hemicube --hemicube " + name + " --patch " + shown(s.patch, 6) +
                                     " --element " + shown(s.element, 6),
                                 s);
        const MeasuredSolution &m = study.measured.back();
        table.rows.push_back({name, std::to_string(b.report.patches), shown(m.seconds), shown(m.wall),
                              shown(m.errors.rms), shown(m.errors.median)});
        std::string file = "raster-" + name + ".png";
        render(b.solution, camera, study.workers, page.path(file));
        pictures.push_back(
            {file, name + " pixels: " + shown(m.errors.rms) + " % off, " + shown(m.seconds) + " s"});
    }
    page.pictures(seen);
    if (table.rows.empty()) return;
    page.table(table);
    page.pictures(pictures);
}

} // namespace

void studyRasters(Study &study) {
    Page &page = study.page;
    double all = study.left();
    page.heading("Rasters from 25 to 800 pixels");
    double ofOne = 0; // a hemicube of each raster
    for (int px : kRasters) ofOne += study.hemicubeSeconds(px);
    // As many patches as let all rasters fit into half of the time
    int asked = 3000;
    while (asked > 375 && study.patchesFor(asked / 2) < study.patchesFor(asked) &&
           1.3 * ofOne * study.patchesFor(asked) + 6 * study.divideSeconds() > all / 2)
        asked /= 2;
    if (study.patchesFor(asked) > 0.8 * study.patchesFor(1500)) asked = std::max(asked, 1500);
    Solved own;
    const Solved &divided = study.divided(asked, own);
    const Model &m = *divided.patches->model;
    // A fifth of the time for one gather
    int count = (int)std::clamp(all / 5 / std::max(6 * ofOne, 1e-9), 48., 1000.);
    Gathering gathering(study, divided, count);
    page.text("First, one gather: " + std::to_string(count) + " patches of " + std::to_string(m.patchCount) +
              " collect the light of the reference, lamps among it. What is wrong then is wrong by the "
              "hemicubes, and by "
              "patches' having one light each. Four hemicubes of half the pixels are anti-aliasing with as "
              "many samples; "
              "at the corners they show what a patch's middle does not stand for.");
    gatherAt(study, gathering, count, all * 0.55);
    page.text("Then whole solutions, every patch with its hemicube. An odd raster has half faces of half a "
              "row more.");
    solveAt(study, asked, gathering);
}

} // namespace odraz
