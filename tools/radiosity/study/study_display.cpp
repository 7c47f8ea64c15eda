// Compares pictures: flat and interpolated light, hemicubes in the middle and at the corners of patches, and
// linear, constant and logarithmic mapping.
#include "tools/common/statistics.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/study/study.h"

#include <algorithm>
#include <numeric>

namespace odraz::radiosity {

namespace {

// The solution with one light value per patch.
Solution flatOf(const Solution &from, const Model &model) {
    Solution flat = from;
    std::vector<Rgb> mean((size_t)model.patchCount);
    std::vector<float> area(mean.size());
    for (const Cell &c : from.cells) {
        if (c.area <= 0) continue;
        Rgb sum = {};
        for (int corner : c.corner) sum += from.light[(size_t)corner];
        mean[(size_t)c.patch] += sum * (c.area / 4), area[(size_t)c.patch] += c.area;
    }
    flat.texels.clear(), flat.light.clear();
    for (Cell &c : flat.cells) {
        auto patch = (size_t)c.patch;
        for (int &corner : c.corner) {
            flat.texels.push_back(from.texels[(size_t)corner]);
            flat.light.push_back(area[patch] > 0 ? mean[patch] * (1 / area[patch]) : Rgb{});
            corner = (int)flat.texels.size() - 1;
        }
    }
    return flat;
}

// Shows a solution with four mappings of radiosity to brightness.
void mappings(Study &study, const Solution &solution) {
    Page &page = study.page;
    // Find the radiosities of surfaces that do not emit, and the largest radiosity of all surfaces
    std::vector<float> all;
    float most = 0;
    bool isLamp = false; // the brightest surface is a lamp
    for (size_t t = 0; t < solution.texels.size(); ++t) {
        auto chart = (size_t)solution.texels[t].chart;
        float light = maxComponent(solution.light[t] * solution.reflects[chart] + solution.emits[chart]);
        if (light > most) most = light, isLamp = maxComponent(solution.emits[chart]) > 0;
        if (maxComponent(solution.emits[chart]) <= 0 && light > 0) all.push_back(light);
    }
    if (all.empty()) return;
    float bright = common::quantile(all, 0.99);
    struct Mapping {
        const char *file, *caption;
        float constant;
        bool logarithmic;
    };
    RenderSettings camera = study.camera();
    std::vector<PagePicture> pictures;
    for (Mapping m : {Mapping{"mapping-linear.png",
                              isLamp ? "linear: the brightest surface, a lamp, is white"
                                     : "linear: the brightest surface is white",
                              1 / std::max(most, 1e-20f), false},
                      {"mapping-constant.png", "times a constant: 1 % of the lit area is brighter than white",
                       1 / bright, false},
                      {"mapping-logarithmic.png", "logarithmic", 0, true},
                      {"mapping-curve.png", "the film's curve", 0, false}}) {
        camera.constant = m.constant, camera.logarithmic = m.logarithmic;
        render(solution, camera, study.workers, page.path(m.file));
        pictures.push_back({m.file, m.caption});
    }
    page.heading("Linear, constant and logarithmic mapping");
    page.text(
        "One solution, shown in four ways. In the first two, brightness on the screen is radiosity times "
        "a constant, as in the thesis. The model's brightest surface is " +
        shown((double)(most / bright)) +
        " times as bright as the 99th percentile of all other lit surfaces.");
    page.pictures(pictures);
}

} // namespace

void studyDisplay(Study &study) {
    study.page.heading("Flat and interpolated; middle and corners");
    PageTable table = {
        "display",
        {"hemicubes", "shown", "patches", "processor_s", "rms_percent", "median_percent"},
        {"hemicubes", "light within a patch", "patches", "processor, s", "error (rms), %", "median, %"}};
    std::vector<PagePicture> pictures;
    RenderSettings camera = study.camera();
    camera.logarithmic = true;
    SolveSettings s = study.thesis(1500, 50);
    auto solve = [&](const std::string &where, const std::string &file) {
        Solved b = study.solve(s);
        const double seconds = std::accumulate(b.report.seconds, std::end(b.report.seconds), 0.);
        auto show = [&](const Solution &solution, const char *how) {
            MeshErrors e = study.errorsOf(solution);
            std::string name = file + "-" + how + ".png";
            render(solution, camera, study.workers, study.page.path(name));
            pictures.push_back({name, where + ", " + how + ": error " + shown(e.rms) + " %"});
            table.rows.push_back({where, how, std::to_string(b.report.patches), shown(seconds), shown(e.rms),
                                  shown(e.median)});
        };
        show(flatOf(b.solution, *b.patches->model), "flat");
        show(b.solution, "interpolated");
        return std::move(b.solution);
    };
    Solution middle = solve("in the middle", "middle");
    s.each = 4, s.eyeOf = cornerEye;
    solve("at four corners", "corners");
    study.page.text(
        "Every patch has a hemicube of 50 pixels in its middle, or the mean of four, one near each corner, a "
        "tenth of the side inside. The light of patches is shown flat, or interpolated between their middles "
        "within one plane; there is no interpolation across edges.");
    study.page.table(table);
    study.page.pictures(pictures);
    mappings(study, middle);
}

} // namespace odraz::radiosity
