// Flat and interpolated, middle and corners; linear, constant and logarithmic mapping: side by side.
#include "tools/common/statistics.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/patches/row_finder.h"
#include "tools/radiosity/study/gathering.h"

#include <algorithm>
#include <cmath>

namespace odraz {

namespace {

// The same solution with one light for each patch.
Solution flatOf(const Solution &from, const Model &model) {
    Solution flat = from;
    std::vector<Rgb> mean((size_t)model.patchCount);
    std::vector<float> area(mean.size());
    for (const Cell &c : from.cells) {
        if (c.divided() || c.area <= 0) continue;
        Rgb sum = {};
        for (int corner : c.corner) sum += from.light[(size_t)corner];
        mean[(size_t)c.patch] += sum * (c.area / 4), area[(size_t)c.patch] += c.area;
    }
    flat.texels.clear(), flat.light.clear();
    for (Cell &c : flat.cells) {
        if (c.divided()) continue;
        auto patch = (size_t)c.patch;
        for (int &corner : c.corner) {
            flat.texels.push_back(from.texels[(size_t)corner]);
            flat.light.push_back(area[patch] > 0 ? mean[patch] * (1 / area[patch]) : Rgb{});
            corner = (int)flat.texels.size() - 1;
        }
    }
    return flat;
}

RenderSettings cameraOf(const Study &study) {
    RenderSettings camera;
    camera.width = 360, camera.height = 270;
    camera.upIsZ = study.settings.upIsZ;
    placeCamera(study.reference, camera);
    return camera;
}

void mappings(Study &study, const Solution &solution) {
    Page &page = study.page;
    // The radiosities of what reflects and does not emit, and the greatest of all
    std::vector<float> all;
    float most = 0;
    for (size_t t = 0; t < solution.texels.size(); ++t) {
        auto chart = (size_t)solution.texels[t].chart;
        float light = maxComponent(solution.light[t] * solution.reflects[chart] + solution.emits[chart]);
        most = std::max(most, light);
        if (maxComponent(solution.emits[chart]) <= 0 && light > 0) all.push_back(light);
    }
    float bright = all.empty() ? 1 : quantile(all, 0.99);
    struct Mapping {
        const char *file, *caption;
        float constant;
        bool logarithmic;
    };
    RenderSettings camera = cameraOf(study);
    std::vector<PagePicture> pictures;
    for (Mapping m : {Mapping{"mapping-linear.png", "linear: the brightest surface is white",
                              1 / std::max(most, 1e-20f), false},
                      {"mapping-constant.png", "times a constant: 1 % of what is lit is brighter than white",
                       1 / bright, false},
                      {"mapping-logarithmic.png", "logarithmic", 0, true},
                      {"mapping-curve.png", "the film's curve", 0, false}}) {
        camera.constant = m.constant, camera.logarithmic = m.logarithmic;
        render(solution, camera, study.workers, page.path(m.file));
        pictures.push_back({m.file, m.caption});
    }
    page.heading("Linear, constant and logarithmic mapping");
    page.text("One solution, shown in four ways. The first two give the screen what is computed, times a "
              "number, as the "
              "thesis does. The model's brightest surface is " +
              shown((double)(most / bright)) +
              " times as bright as what 99 % of all other lit surfaces do not exceed.");
    page.pictures(pictures);
    study.advice.push_back(
        std::string("Mapping: ") +
        (most / bright > 4
             ? "logarithmic, or the film's curve: the lamps outshine what they light by " +
                   shown((double)(most / bright)) + " times, and a linear mapping leaves that dark."
             : "any: nothing outshines the rest by more than " + shown((double)(most / bright)) + " times."));
}

} // namespace

void studyDisplay(Study &study) {
    Page &page = study.page;
    RenderSettings camera = cameraOf(study);
    camera.logarithmic = true;
    std::vector<PagePicture> pictures;
    PageTable table = {
        "display",
        {"hemicubes", "shown", "patches", "processor_s", "rms_percent", "median_percent"},
        {"hemicubes", "light within a patch", "patches", "processor, s", "error (rms), %", "median, %"}};
    auto show = [&](const std::string &where, const std::string &file, const Solution &s, const Model &m,
                    double seconds) {
        double errors[2] = {};
        for (bool flat : {true, false}) {
            Solution shownAs = flat ? flatOf(s, m) : s;
            LightErrors e = study.places->errorsOf(shownAs);
            errors[flat] = e.rms;
            std::string how = flat ? "flat" : "interpolated", name = file + "-" + how + ".png";
            render(shownAs, camera, study.workers, page.path(name));
            pictures.push_back({name, where + ", " + how + ": " + shown(e.rms) + " % off"});
            table.rows.push_back(
                {where, how, std::to_string(m.patchCount), shown(seconds), shown(e.rms), shown(e.median)});
            study.tick();
        }
        return std::pair{errors[1], errors[0]};
    };
    page.heading("Flat and interpolated; middle and corners");
    int px = 0;
    double one = 0;
    for (int tried : {50, 32, 16})
        if (!px && study.fits(6 * study.patchesFor(1500) * (one = study.hemicubeSeconds(tried)) +
                              2 * study.divideSeconds()))
            px = tried;
    const Solution *solution = nullptr;
    Solved solved[2];
    if (px) {
        double flat = 0, smooth = 0, corners = 0;
        for (bool atCorners : {false, true}) {
            SolveSettings s = study.thesis(1500, px);
            if (atCorners)
                s.findRows = [&study, px](const Model &m, const Scene &scene, const uint8_t *lit,
                                          Workers &workers, Arena &arena, FormFactors &factors,
                                          const Progress &progress) {
                    EyeOf eyes = [&m](int patch, int k) { return cornerEye(m, patch, k); };
                    return rowsByHemicubes(study.gl, px, 4, 0, eyes)(m, scene, lit, workers, arena, factors,
                                                                     progress);
                };
            std::string where = atCorners ? "at four corners" : "in the middle";
            Solved &b = solved[atCorners] = study.solve(s);
            auto [f, i] = show(where, atCorners ? "corners" : "middle", b.solution, *b.patches->model,
                               b.report.allSeconds);
            (atCorners ? corners : smooth) = i;
            if (!atCorners) flat = f;
        }
        solution = &solved[0].solution;
        page.text(
            "Every patch has a hemicube of " + std::to_string(px) +
            " pixels in its middle, or one near each of its "
            "corners, a tenth of its side inside, whose mean counts. The light of patches is shown flat, or "
            "interpolated between their middles within one plane; across edges nothing is interpolated.");
        study.advice.push_back("Display: " + std::string(smooth < flat ? "interpolated" : "flat") + ": " +
                               shown(std::min(smooth, flat)) + " % off instead of " +
                               shown(std::max(smooth, flat)) + " %, at no cost.");
        study.advice.push_back(
            "Middle or corners: " + std::string(corners < 0.9 * smooth ? "the corners" : "the middle") +
            ": four hemicubes at the corners are " + shown(corners) + " % off, one in the middle " +
            shown(smooth) + " %, for " +
            shown(solved[1].report.allSeconds / std::max(solved[0].report.allSeconds, 1e-9), 2) +
            " times the time.");
    } else {
        // Too many patches: shots instead of rows
        SolveSettings s = study.thesis(1500, 50);
        double seconds = (study.left() - study.divideSeconds()) / 2;
        s.shots = (int)std::clamp(seconds / std::max(one, 1e-6), 50., 4000.);
        Solved &b = solved[0] = study.solve(s);
        show(std::to_string(b.report.shots) + " shots", "shots", b.solution, *b.patches->model,
             b.report.allSeconds);
        solution = &b.solution;
        page.text("The light is shot. It is shown flat, one light for each patch, or interpolated between "
                  "their middles "
                  "within one plane.");
        study.leftOut.push_back(
            "display: hemicubes at corners, whose rows take too long (one gather has them)");
    }
    page.table(table);
    page.pictures(pictures);
    mappings(study, *solution);
}

} // namespace odraz
