// Rasters from 25 to 800 pixels; anti-aliasing and corners against more pixels.
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/study/gathering.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace odraz::radiosity {

namespace {

constexpr int kRasters[] = {25, 50, 100, 200, 400, 800};

// The ways to gather that are compared.
constexpr const char *kWays[] = {"one in the middle", "four turned differently", "four near the corners"};

struct Tried {
    int px, way;
    Gathering::Result result;
    double fromFinest = NAN; // percent (rms), NAN: not compared

    double ms() const { return 1000 * result.seconds; }
    std::string name() const { return std::string(kWays[way]) + ", of " + std::to_string(px) + " pixels"; }
};

std::vector<Tried> tryAll(Study &study, Gathering &gathering, double patches, double until) {
    std::vector<Tried> tried;
    for (int px : kRasters)
        for (int way = 0; way < 3; ++way) {
            // Four hemicubes of half the pixels have the same total
            int of = way ? px / 2 : px;
            if (of < 12) continue;
            double more = tried.empty() ? 0 : tried.back().result.seconds * patches * 4;
            if (study.left() < until || more > study.left() - until) {
                study.leftOut.push_back("one gather: " + std::to_string(of) + " pixels, " + kWays[way]);
                continue;
            }
            tried.push_back({of, way, gathering.measure({of, way == 1 ? 4 : 1, way == 2})});
        }
    // The effect of pixels alone: hemicubes in the middle, against the finest raster
    const Tried *finest = nullptr;
    for (const Tried &t : tried)
        if (t.way == 0 && (!finest || t.px > finest->px)) finest = &t;
    for (Tried &t : tried)
        if (finest && &t != finest && t.way < 2)
            t.fromFinest = errorsOf(t.result.light, finest->result.light).rms;
    return tried;
}

// The cheapest within `percent` of the finest raster. Costs that differ by less than a tenth count as equal;
// of these it is the first, which has fewer pixels.
const Tried *cheapest(const std::vector<Tried> &tried, double percent) {
    const Tried *best = nullptr;
    for (const Tried &t : tried)
        if (t.fromFinest <= percent && (!best || t.ms() < 0.9 * best->ms())) best = &t;
    return best;
}

// Compares more pixels with anti-aliasing, for the same number of pixels in total.
void adviseFour(Study &study, const std::vector<Tried> &tried) {
    int ahead = 0, all = 0;
    double ratio = 0;
    for (const Tried &four : tried)
        for (const Tried &one : tried) {
            if (four.way != 1 || one.way != 0 || one.px / 2 != four.px) continue;
            if (!(four.fromFinest > 0 && one.fromFinest > 0)) continue;
            ++all, ahead += one.fromFinest < four.fromFinest;
            ratio += std::log(four.fromFinest / one.fromFinest);
        }
    if (all == 0) return;
    study.advice.push_back(
        "More pixels or anti-aliasing: with the same number of pixels, one hemicube is closer to "
        "the finest raster than four of half its pixels in " +
        std::to_string(ahead) + " of " + std::to_string(all) + " rasters; the error of the four is " +
        shown(std::exp(ratio / all), 2) + " times as large.");
}

void gatherAt(Study &study, Gathering &gathering, double patches, double until) {
    std::vector<Tried> tried = tryAll(study, gathering, patches, until);
    if (tried.empty()) return;
    PageTable table = {
        "gathering",
        {"hemicubes", "px", "processor_ms_per_patch", "rms_percent", "median_percent", "from_finest_percent"},
        {"hemicubes of a patch", "pixels", "ms a patch", "error (rms), %", "median, %",
         "off the finest (rms), %"}};
    pictures::Plot plot =
        errorPlot("one gather: what the raster alone does, against time", "processor time of a patch, ms",
                  "off one hemicube with most pixels (rms), %", {kWays[0], kWays[1]});
    double least = INFINITY;
    for (const Tried &t : tried) {
        const MeshErrors &e = t.result.errors;
        least = std::min(least, e.rms);
        table.rows.push_back({kWays[t.way], std::to_string(t.px), shown(t.ms()), shown(e.rms),
                              shown(e.median), shown(t.fromFinest)});
        if (t.way < 2) plot.points.push_back({t.ms(), t.fromFinest, std::to_string(t.px), false, t.way});
    }
    study.page.table(table);
    study.page.plot("gathering", plot);
    // A raster may cause a fifth of the error allowed for a whole solution
    double allowed = study.settings.within / 5, most = 0;
    for (const Tried &t : tried) most = std::max(most, std::isfinite(t.fromFinest) ? t.fromFinest : 0);
    if (most < 0.01) // in percent; one plane sees nothing, for instance
        study.advice.push_back("Hemicubes: any: rasters make no difference in this model.");
    else if (const Tried *t = cheapest(tried, allowed))
        study.advice.push_back("Hemicubes: " + t->name() + ": " + shown(t->fromFinest) +
                               " % off the finest raster for " + shown(t->ms()) +
                               " ms a patch, the cheapest within " + shown(allowed) +
                               " %. Against the reference the smallest error is " + shown(least) +
                               " %, from pixels and from patches that have one light value each.");
    else
        study.advice.push_back("Hemicubes: no raster that was tried is within " + shown(allowed) +
                               " % of the finest one.");
    if (most >= 0.01) adviseFour(study, tried);
}

// Whole solutions, with pictures.
void solveAt(Study &study, int asked, Gathering &gathering) {
    Page &page = study.page;
    PageTable table = {"rasters",
                       {"px", "patches", "processor_s", "wall_s", "rms_percent", "median_percent"},
                       {"pixels", "patches", "processor, s", "clock, s", "error (rms), %", "median, %"}};
    std::vector<PagePicture> pictures, seen;
    RenderSettings camera = study.camera();
    camera.logarithmic = true;
    int widest = gathering.patchSeeingMost();
    for (int px : kRasters) {
        std::string name = std::to_string(px);
        if (widest >= 0) {
            std::string file = "hemicube-" + name + ".png";
            pictures::writePng(page.path(file), gathering.unfolded(widest, px));
            seen.push_back({file, "what one patch sees, " + name + " pixels"});
        }
        bool fits =
            study.fits(1.3 * study.patchesFor(asked) * study.hemicubeSeconds(px) + study.divideSeconds());
        // In a model of many polygons, the first chapter has about this number of patches
        Gathered &known = study.gathered;
        Solved solved;
        if (fits) {
            solved = study.gather(asked, px);
        } else if (px != known.px || known.patches > 1.2 * study.patchesFor(asked)) {
            study.leftOut.push_back("rasters: a whole solution with " + name + " pixels");
            continue;
        }
        const MeasuredSolution &m = fits ? study.measured.back() : known.measured;
        table.rows.push_back({name, std::to_string(fits ? solved.report.patches : known.patches),
                              shown(m.seconds), shown(m.wall), shown(m.errors.rms), shown(m.errors.median)});
        std::string file = "raster-" + name + ".png";
        render(fits ? solved.solution : known.solution, camera, study.workers, page.path(file));
        pictures.push_back(
            {file, name + " pixels: " + shown(m.errors.rms) + " % off, " + shown(m.seconds) + " s"});
    }
    page.pictures(seen);
    if (table.rows.empty()) return;
    page.text("Whole solutions, with a hemicube for every patch. The half faces of an odd raster have half a "
              "row more.");
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
    // The number of patches for which all rasters take half of the time
    int asked = 3000;
    while (asked > 375 && study.patchesFor(asked / 2) < study.patchesFor(asked) &&
           1.3 * ofOne * study.patchesFor(asked) + 6 * study.divideSeconds() > all / 2)
        asked /= 2;
    if (study.patchesFor(asked) > 0.8 * study.patchesFor(1500)) asked = std::max(asked, 1500);
    Solved own;
    const Solved &divided = study.divided(asked, own);
    const Model &m = *divided.patches->model;
    // One gather takes a fifth of the time
    int count = (int)std::clamp(all / 5 / std::max(6 * ofOne, 1e-9), 48., 1000.);
    Gathering gathering(study, divided, count);
    page.text(
        "First, one gather: " + std::to_string(gathering.count()) + " patches of " +
        std::to_string(m.patchCount) +
        " gather the light of the reference, including that of lamps. The error against the reference has "
        "two causes: the raster, and patches that have one light value each. The plot shows only the first, "
        "as the difference from the finest raster. Four hemicubes of half the pixels are anti-aliasing with "
        "the same number of samples; at the corners they show the effect of a hemicube in the middle.");
    gatherAt(study, gathering, count, all * 0.55);
    solveAt(study, asked, gathering);
}

} // namespace odraz::radiosity
