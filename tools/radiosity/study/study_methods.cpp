// Compares gathering, Gauss-Seidel and shooting, the light that each pass adds, and two orders of update.
#include "tools/radiosity/patches/shooting.h"
#include "tools/radiosity/study/study.h"
#include "tools/support/luminance.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

namespace {

constexpr int kMostPasses = 60;
constexpr double kDone = 1e-4; // a curve ends below this error, percent

// A pass over all patches, or several shots.
struct CurveStep {
    int number;     // number of passes or hemicubes so far
    double seconds; // processor time since the start
    double error;   // rms difference from the converged light, percent of the rms light
    double light;   // light so far, percent of the converged light
};

struct Curve {
    std::string name;
    std::vector<CurveStep> steps;
};

// The system of a solution by patches, and its converged light.
class Converging {
public:
    // `solved`: a solution by hemicubes that see the lamps, with rows.
    Converging(Study &study, Solved &solved)
        : study(study), patches(*solved.patches),
          rowSeconds(solved.report.seconds[(int)SolveStep::kFormFactors]) {
        for (int sweeps = 0; sweeps < 300 && patches.sweep(converged, true) > 1e-6f;) ++sweeps;
        for (size_t i = 0; i < converged.size(); ++i) {
            double light = (double)luminance(converged[i]), a = (double)patches.patches[i].area;
            all += light * light * a, power += light * a;
        }
    }

    // Passes that use the light of the previous pass (Jacobi), or new light at once (Gauss-Seidel).
    Curve passes(bool atOnce) {
        Curve curve = {atOnce ? "Gauss-Seidel (at once)" : "gathering (in the next pass)", {}};
        std::vector<Rgb> light(patches.patches.size());
        double seconds = rowSeconds;
        for (int pass = 1; pass <= kMostPasses; ++pass) {
            study.check();
            Stopwatch watch;
            patches.sweep(light, atOnce);
            seconds += watch.processor();
            curve.steps.push_back(stepOf(pass, seconds, light));
            if (curve.steps.back().error < kDone) break;
        }
        return curve;
    }
    // Shots that use the form factors of the rows.
    Curve shootingRows() {
        Curve curve = {"shooting over the rows", {}};
        Stopwatch watch;
        const auto columns = patches.rows.columns();
        Shooting shooting(model, patchesAlone(model), std::vector<Rgb>(patches.patches.size()),
                          patches.direct);
        int64_t left = 60 * (int64_t)model.patchCount;
        shoot(curve, shooting, rowSeconds + watch.processor(), 64, 1e-6, [&] {
            if (left <= 0) return 0;
            int shots = 0;
            for (int k : shooting.brightest(64)) {
                Shooting::Shot shot = shooting.nextShot(k);
                shooting.distribute(shot.power * (1 / model.patches[shot.patch].area),
                                    columns[(size_t)shot.patch]);
                ++shots;
            }
            left -= shots;
            return shots;
        });
        return curve;
    }
    // Shots by hemicubes, without rows, lamps first, as in `solve --shots`. For N patches, single patches
    // shoot 2 N times in all. There are N / 8 blocks, which shoot N / 2 times in all.
    Curve shooting(int px, bool blocks) {
        Curve curve = {blocks ? "shooting by hemicubes, blocks" : "shooting by hemicubes, single patches",
                       {}};
        // Subtract the light of lamps, which the rows added to the direct light and which is shot here
        std::vector<Rgb> direct;
        for (int i = 0; i < model.patchCount; ++i) {
            Rgb arrives = patches.direct[(size_t)i] - patches.rows.gather(i, patches.emits);
            direct.push_back({std::max(arrives.x, 0.f), std::max(arrives.y, 0.f), std::max(arrives.z, 0.f)});
        }
        int left = blocks ? model.patchCount / 2 : 2 * model.patchCount;
        // Make so few blocks that each can shoot several times
        Shooters shooters = blocks ? blocksOfPatches(model, patches.emits, std::max(model.patchCount / 8, 1))
                                   : patchesAlone(model);
        Shooting shooting(model, std::move(shooters), patches.emits, direct);
        AnyHemicubes hemicubes(study.gl, px);
        shoot(curve, shooting, 0, 16, 1e-4, [&] {
            int shots = left > 0 ? shooting.shoot(hemicubes, hemicubes.h.batch, study.workers) : 0;
            left -= shots;
            return shots;
        });
        return curve;
    }
    // Whether no light is reflected.
    bool dark() const { return !(power > 0); }

private:
    Study &study;
    const PatchSystem &patches;
    const Model &model = *patches.model;
    double rowSeconds;
    std::vector<Rgb> converged = patches.reflectDirect();
    double all = 0, power = 0;
    // Calls `shots`, which shoots and returns its number of shots, until it returns 0, until less than the
    // share `least` of the light is unshot, or until the light has converged. `seconds`: the time before the
    // first shot. Records a step after `first` shots, and then whenever their number has grown by a quarter.
    void shoot(Curve &curve, Shooting &shooting, double seconds, int first, double least,
               const std::function<int()> &shots) const {
        int count = 0, next = first;
        auto record = [&] {
            if (count == 0 || (!curve.steps.empty() && curve.steps.back().number == count)) return;
            curve.steps.push_back(stepOf(count, seconds, shooting.radiosity()));
        };
        while (shooting.left() > least) {
            study.check();
            Stopwatch batch;
            int more = shots();
            if (more == 0) break;
            count += more, seconds += batch.processor();
            if (count < next) continue;
            next = count + count / 4;
            record();
            if (curve.steps.back().error < kDone) break;
        }
        record();
    }

    CurveStep stepOf(int number, double seconds, const std::vector<Rgb> &radiosity) const {
        double error = 0, now = 0;
        for (int i = 0; i < model.patchCount; ++i) {
            double light = (double)luminance(radiosity[(size_t)i]),
                   gap = light - (double)luminance(converged[(size_t)i]), a = (double)model.patches[i].area;
            error += gap * gap * a, now += light * a;
        }
        return {number, seconds, all > 0 ? 100 * std::sqrt(error / all) : 0,
                power > 0 ? 100 * now / power : 0};
    }
};

// The first step of a curve whose error is at most `percent`; null: none.
const CurveStep *firstWithin(const Curve &curve, double percent) {
    for (const CurveStep &s : curve.steps)
        if (s.error <= percent) return &s;
    return nullptr;
}

void writePasses(Study &study, const Curve &next, const Curve &once) {
    Page &page = study.page;
    page.heading("What every pass adds");
    page.text(
        "The light that all surfaces reflect, and the share of the converged light that each pass adds. In "
        "the next pass: a pass gathers the light of the previous pass, as in the thesis, so each pass adds "
        "one bounce. At once: a patch also gathers light that other patches found earlier in the same pass.");
    PageTable table = {"passes",
                       {"pass", "added_next_percent", "left_next_percent", "error_next_percent",
                        "added_once_percent", "left_once_percent", "error_once_percent"},
                       {"pass", "adds, in the next pass, %", "is left, %", "error (rms), %",
                        "adds, at once, %", "is left, %", "error (rms), %"}};
    pictures::Plot left = errorPlot("light that is left after each pass", "pass",
                                    "left, % of the converged light", {"in the next pass", "at once"});
    left.logarithmicX = false;
    pictures::Plot error = left;
    error.title = "convergence: the error after each pass", error.yName = "error (rms), %";
    left.joined = error.joined = true;
    for (size_t k = 0; k < std::min(std::max(next.steps.size(), once.steps.size()), (size_t)30); ++k) {
        std::vector<std::string> row = {std::to_string(k + 1)};
        for (int c = 0; c < 2; ++c) {
            const std::vector<CurveStep> &steps = (c ? once : next).steps;
            if (k >= steps.size()) {
                row.insert(row.end(), 3, "");
                continue;
            }
            double added = steps[k].light - (k ? steps[k - 1].light : 0),
                   rest = std::max(100 - steps[k].light, 0.); // rounding may let the light exceed 100 %
            row.insert(row.end(), {shown(added), shown(rest), shown(steps[k].error)});
            if (rest > 1e-3) left.points.push_back({(double)k + 1, rest, "", false, c});
            error.points.push_back({(double)k + 1, steps[k].error, "", false, c});
        }
        table.rows.push_back(row);
    }
    page.table(table);
    page.plot("passes", left);
    page.plot("convergence", error);
}

void writeOrders(Study &study, const Curve &next, const Curve &once) {
    PageTable table = {"orders",
                       {"error_percent", "passes_next", "passes_once"},
                       {"error (rms) at most, %", "passes, in the next pass", "passes, at once"}};
    for (double percent : {10., 1., 0.1, 0.01}) {
        const CurveStep *a = firstWithin(next, percent), *b = firstWithin(once, percent);
        table.rows.push_back(
            {shown(percent), a ? std::to_string(a->number) : "", b ? std::to_string(b->number) : ""});
    }
    study.page.heading("Two orders of update");
    study.page.text("The number of passes until the light is this close to the converged light.");
    study.page.table(table);
}

void writeMethods(Study &study, const std::vector<Curve> &curves) {
    PageTable table = {"methods",
                       {"method", "step", "processor_s", "error_percent"},
                       {"method", "passes or shots", "processor, s", "error (rms), %"}};
    PageTable within = {
        "methods_within",
        {"method", "to_10_percent_s", "to_1_percent_s", "to_0.1_percent_s", "last_error_percent"},
        {"method", "to 10 %, s", "to 1 %, s", "to 0.1 %, s", "least error, %"}};
    pictures::Plot plot =
        errorPlot("gathering, Gauss-Seidel and shooting: error against time",
                  "processor time, form factors included, s", "error (rms) against the converged light, %");
    plot.joined = true;
    for (size_t c = 0; c < curves.size(); ++c) {
        plot.series.push_back(curves[c].name);
        std::vector<std::string> row = {curves[c].name};
        for (double percent : {10., 1., 0.1}) {
            const CurveStep *s = firstWithin(curves[c], percent);
            row.push_back(s ? shown(s->seconds) : "");
        }
        double least = INFINITY;
        for (const CurveStep &s : curves[c].steps) {
            least = std::min(least, s.error);
            table.rows.push_back(
                {curves[c].name, std::to_string(s.number), shown(s.seconds, 4), shown(s.error)});
            plot.points.push_back({s.seconds, s.error, "", false, (int)c});
        }
        row.push_back(shown(least));
        within.rows.push_back(row);
    }
    Page &page = study.page;
    page.plot("methods", plot);
    page.table(within);
    page.table(table, false);
}

} // namespace

void studyMethods(Study &study) {
    Page &page = study.page;
    page.heading("Gathering, Gauss-Seidel and shooting");
    constexpr int px = 50;
    Solved base = study.measure(study.settings.quick ? 1500 : 3000, px);
    Converging converging(study, base);
    if (converging.dark()) return page.text("No light is reflected: there is nothing to compare.");
    std::vector<Curve> curves = {converging.passes(false), converging.passes(true),
                                 converging.shootingRows()};
    for (bool blocks : {false, true}) curves.push_back(converging.shooting(px, blocks));
    page.text(
        std::to_string(base.report.patches) + " patches with hemicubes of " + std::to_string(px) +
        " pixels. Gathering and Gauss-Seidel need all rows before their first pass; shooting needs one "
        "hemicube a shot, and another one if a patch shoots again. With the same rows all methods reach the "
        "same light. Shots by hemicubes differ slightly: by reciprocity they use the form factors from the "
        "other side, which differ if a hemicube is coarse. Patches shoot singly, or in blocks with one "
        "hemicube for all patches of a block, as in radiosity solve --shots: faster, but less exact.");
    writeMethods(study, curves);
    writePasses(study, curves[0], curves[1]);
    writeOrders(study, curves[0], curves[1]);
}

} // namespace odraz::radiosity
