// Compares rasters from 25 to 800 pixels, and anti-aliasing and corners with more pixels.
#include "tools/common/statistics.h"
#include "tools/radiosity/export/render.h"
#include "tools/radiosity/patches/any_hemicube.h"
#include "tools/radiosity/study/study.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

namespace odraz::radiosity {

namespace {

constexpr int kRasters[] = {25, 50, 100, 200, 400, 800}, kPatches = 1500;

std::span<const int> rasters(const Study &study) {
    return std::span(kRasters).first(study.settings.quick ? 4 : std::size(kRasters));
}

constexpr int kUnfolded = 480;         // pixels along a picture's side
constexpr int kWithin = 3;             // samples along a pixel's side
constexpr double kLeastSeconds = 0.05; // duration of a measurement

// One gather of known light by hemicubes at some patches of a model. It isolates the effect of rasters,
// anti-aliasing and hemicubes at corners.
class Gathering {
public:
    // `divided`: a solution by patches, whose light is not used; it must outlive this. Up to `count` patches
    // gather.
    Gathering(Study &study, const Solved &divided, int count)
        : study(study), model(*divided.patches->model), radiosity((size_t)model.patchCount) {
        const Solution &reference = study.reference;
        std::vector<int> visible;
        for (int i = 0; i < model.patchCount; ++i) {
            const Patch &p = model.patches[i];
            auto chart = (size_t)p.chart;
            radiosity[(size_t)i] = reference.radiosityAt(p.chart, p.p);
            if (p.share > 0 && maxComponent(reference.reflects[chart]) > 0) visible.push_back(i);
        }
        // Spread the gathering patches by area, like the points of all other errors; take a large patch only
        // once
        std::vector<double> sums;
        double area = 0;
        for (int i : visible) sums.push_back(area += (double)model.patches[i].area);
        for (int k = 0, last = -1; k < count && !visible.empty(); ++k) {
            auto at = std::upper_bound(sums.begin(), sums.end(), area * (k + 0.5) / count) - sums.begin();
            int i = visible[std::min((size_t)at, visible.size() - 1)];
            if (i == last) continue;
            last = i;
            patches.push_back(i);
            outside.push_back(luminance(divided.patches->direct[(size_t)i]));
            expected.push_back(luminance(reference.lightAt(model.patches[i].chart, model.patches[i].p)));
        }
    }

    size_t count() const { return patches.size(); }

    struct Result {
        MeshErrors errors;        // errors of the light that arrives at the patches
        double seconds;           // processor time per patch
        std::vector<float> light; // luminance of the light that arrives at each patch
    };
    // Gathers by `each` hemicubes at each patch: in its middle, rotated differently, or four at its corners.
    Result measure(int px, int each, bool corners) {
        if (patches.empty()) return {errorsOf(expected, expected), NAN, {}};
        AnyHemicubes hemicubes(study.gl, px);
        const auto batch = (size_t)hemicubes.h.batch;
        std::vector<Eye> eyes;
        for (int i : patches)
            for (int k = 0; k < each; ++k)
                eyes.push_back(corners ? cornerEye(model, i, k)
                                       : hemicubeEye(model.patches[i].p, model.patches[i].n,
                                                     (uint32_t)i + (uint32_t)k * 0x9e3779b9u));
        // Draw once untimed, because the first picture takes longer. Measure a few patches several times
        hemicubes.draw(model, {&eyes[0], 1});
        Workers serial = serialWorkers();
        Stopwatch watch;
        std::vector<float> light;
        int rounds = 0;
        for (; rounds == 0 || (rounds < 20 && watch.processor() < kLeastSeconds); ++rounds) {
            light.assign(patches.size(), 0);
            for (size_t first = 0; first < eyes.size(); first += batch) {
                study.check();
                auto batchEyes = std::span(eyes).subspan(first, std::min(batch, eyes.size() - first));
                const auto &rows = hemicubes.rows(model, batchEyes, serial);
                for (size_t k = 0; k < rows.size(); ++k) {
                    float sum = 0;
                    for (size_t j = 0; j < radiosity.size(); ++j)
                        if (rows[k][j] > 0) sum += rows[k][j] * luminance(radiosity[j]);
                    light[(first + k) / (size_t)each] += sum / (float)each;
                }
            }
        }
        double seconds = watch.processor() / (double)(patches.size() * (size_t)rounds);
        for (size_t i = 0; i < light.size(); ++i) light[i] += outside[i];
        study.taskDone();
        return {errorsOf(light, expected), seconds, std::move(light)};
    }

    // The gathering patch that sees the largest number of patches.
    int patchSeeingMost() {
        AnyHemicubes opened(study.gl, 50);
        int best = -1;
        size_t most = 0;
        for (size_t k = 0; k < patches.size(); k += std::max(patches.size() / 32, (size_t)1)) {
            const Patch &p = model.patches[patches[k]];
            Eye eye = hemicubeEye(p.p, p.n, (uint32_t)patches[k]);
            opened.draw(model, {&eye, 1});
            std::set<uint32_t> seen;
            for (int y = 0; y < 150; ++y)
                for (int x = 0; x < 50; ++x)
                    seen.insert(hemicubeIds(opened.h, 0)[y * hemicubeStride(opened.h) + x]);
            if (seen.size() > most) most = seen.size(), best = patches[k];
        }
        return best;
    }

    // The picture in a patch's hemicube, unfolded around its top face, by logarithmicTone().
    pictures::Image unfolded(int patch, int px) {
        AnyHemicubes opened(study.gl, px);
        const Patch &p = model.patches[patch];
        Eye eye = hemicubeEye(p.p, p.n, (uint32_t)patch);
        opened.draw(model, {&eye, 1});
        const uint32_t *ids = hemicubeIds(opened.h, 0);
        int stride = hemicubeStride(opened.h);
        std::vector<float> all;
        for (const Rgb &c : radiosity)
            if (luminance(c) > 0) all.push_back(std::log(luminance(c)));
        float low = all.empty() ? 0 : common::quantile(all, 0.02),
              high = all.empty() ? 1 : common::quantile(all, 0.998);
        // The raster's id at a point in -2 .. 2, or null outside the faces: the top face extends from -1 to
        // 1, and the half faces end with the horizon at -2 and 2
        auto idAt = [&](float x, float y) -> const uint32_t * {
            bool beyondX = std::fabs(x) > 1, beyondY = std::fabs(y) > 1;
            if (beyondX && beyondY) return nullptr;
            int side = x > 1 ? 0 : y > 1 ? 1 : x < -1 ? 2 : y < -1 ? 3 : -1;
            float along[4] = {y, -x, -y, x}, up = 2 - (beyondX ? std::fabs(x) : std::fabs(y)), n = (float)px;
            float column = side < 0 ? x : along[side],
                  line = side < 0 ? (y + 1) / 2 * n : n + ((float)side + up) * n / 2;
            // In odd rasters, a point between the rows of half faces belongs to the row above
            int row = std::clamp((int)line, 0, 3 * px - 1);
            if (px % 2 && side >= 0 && (row - px) % px == px / 2) row += side % 2 ? 1 : -1;
            return &ids[row * stride + std::clamp((int)((column + 1) / 2 * n), 0, px - 1)];
        };
        auto shade = [&](uint32_t id) {
            Rgb c = id == kNothing || id == kBackSide ? Rgb{} : radiosity[id - 1];
            return maxComponent(c) > 0 ? logarithmicTone(c, low, high) * 255.f : Rgb{30, 30, 30};
        };
        pictures::Image picture = {kUnfolded, kUnfolded,
                                   std::vector<uint8_t>((size_t)kUnfolded * kUnfolded * 3, 255)};
        constexpr int kPoints = kUnfolded * kWithin;
        for (int j = 0; j < kUnfolded; ++j)
            for (int i = 0; i < kUnfolded; ++i) {
                Rgb sum = {};
                for (int k = 0; k < kWithin * kWithin; ++k) {
                    float x = ((float)(i * kWithin + k % kWithin) + 0.5f) * 4 / kPoints - 2,
                          y = 2 - ((float)(j * kWithin + k / kWithin) + 0.5f) * 4 / kPoints;
                    const uint32_t *id = idAt(x, y);
                    sum += id ? shade(*id) : Rgb{255, 255, 255};
                }
                uint8_t *to = &picture.rgb[((size_t)j * kUnfolded + (size_t)i) * 3];
                const float mean[3] = {sum.x, sum.y, sum.z};
                for (int k = 0; k < 3; ++k) to[k] = (uint8_t)(mean[k] / (kWithin * kWithin) + 0.5f);
            }
        return picture;
    }

private:
    Study &study;
    const Model &model;
    std::vector<int> patches;    // the gathering patches
    std::vector<Rgb> radiosity;  // radiosity of all patches in the reference
    std::vector<float> outside;  // luminance of the light from outside at the gathering patches
    std::vector<float> expected; // luminance of all light that arrives there in the reference
};

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
