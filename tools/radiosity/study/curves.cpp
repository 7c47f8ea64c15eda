#include "tools/radiosity/study/curves.h"

#include "tools/engine/luminance.h"
#include "tools/radiosity/patches/shooting.h"

#include <algorithm>
#include <cmath>

namespace odraz::radiosity {

namespace {

constexpr int kMostPasses = 60;
constexpr double kDone = 1e-4; // percent: a curve ends below this error

} // namespace

Converging::Converging(Study &study, Solved &solved)
    : study(study), patches(*solved.patches), model(*patches.model),
      rowSeconds(solved.report.seconds[(int)SolveStep::kFormFactors]), converged(patches.reflectDirect()) {
    for (int sweeps = 0; sweeps < 300 && patches.sweep(converged, true) > 1e-6f;) ++sweeps;
    for (size_t i = 0; i < converged.size(); ++i) {
        double light = (double)luminance(converged[i]), a = (double)patches.patches[i].area;
        all += light * light * a, power += light * a;
    }
}

Step Converging::stepOf(int number, double seconds, const std::function<Rgb(int)> &radiosity,
                        double &before) const {
    double error = 0, now = 0;
    for (int i = 0; i < model.patchCount; ++i) {
        double light = (double)luminance(radiosity(i)), off = light - (double)luminance(converged[(size_t)i]),
               a = (double)model.patches[i].area;
        error += off * off * a, now += light * a;
    }
    double gained = power > 0 ? 100 * (now - before) / power : 0;
    before = now;
    return {number, seconds, all > 0 ? 100 * std::sqrt(error / all) : 0, gained};
}

Curve Converging::passes(bool atOnce) {
    Curve curve = {atOnce ? "Gauss-Seidel (at once)" : "gathering (in the next pass)", {}};
    std::vector<Rgb> light(patches.patches.size());
    double seconds = rowSeconds, before = 0;
    for (int pass = 1; pass <= kMostPasses; ++pass) {
        study.check();
        Stopwatch watch;
        patches.sweep(light, atOnce);
        seconds += watch.processor();
        curve.steps.push_back(stepOf(
            pass, seconds, [&](int i) { return light[(size_t)i]; }, before));
        if (curve.steps.back().error < kDone) break;
    }
    return curve;
}

void Converging::shoot(Curve &curve, Shooting &shooting, double seconds, int first, double least,
                       const std::function<int()> &shots) const {
    int count = 0, next = first;
    double before = 0;
    auto record = [&] {
        if (count == 0 || (!curve.steps.empty() && curve.steps.back().number == count)) return;
        curve.steps.push_back(stepOf(
            count, seconds, [&](int i) { return shooting.radiosity(i); }, before));
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

Curve Converging::shootingRows() {
    Curve curve = {"shooting over the rows", {}};
    Stopwatch watch;
    Columns columns(patches.rows);
    Shooting shooting(model, patchesAlone(model), std::vector<Rgb>(patches.patches.size()), patches.direct);
    int64_t left = 60 * (int64_t)model.patchCount;
    shoot(curve, shooting, rowSeconds + watch.processor(), 64, 1e-6, [&] {
        if (left <= 0) return 0;
        int shots = 0;
        for (int k : shooting.brightest(64)) {
            Shooting::Shot shot = shooting.take(k);
            shooting.distribute(shot.power * (1 / model.patches[shot.patch].area), columns.of(shot.patch));
            ++shots;
        }
        left -= shots;
        return shots;
    });
    return curve;
}

Curve Converging::shooting(int px, bool blocks) {
    Curve curve = {blocks ? "shooting by hemicubes, blocks" : "shooting by hemicubes, single patches", {}};
    // Light from the lamps, which the rows brought, is shot here; only light from outside is direct
    std::vector<Rgb> direct;
    for (int i = 0; i < model.patchCount; ++i) {
        Rgb arrives = patches.direct[(size_t)i] - patches.rows.gather(i, patches.emits);
        direct.push_back({std::max(arrives.x, 0.f), std::max(arrives.y, 0.f), std::max(arrives.z, 0.f)});
    }
    int left = blocks ? model.patchCount / 2 : 2 * model.patchCount;
    // There are few enough blocks for each to shoot several times
    Shooters shooters = blocks ? blocksOfPatches(model, patches.emits, std::max(model.patchCount / 8, 1))
                               : patchesAlone(model);
    Shooting shooting(model, std::move(shooters), patches.emits, direct);
    HemicubeShooter shooter(study.gl, model, px);
    shoot(curve, shooting, 0, 16, 1e-4, [&] {
        int shots = left > 0 ? shooter.shoot(shooting, shooter.batch(), study.workers) : 0;
        left -= shots;
        return shots;
    });
    return curve;
}

} // namespace odraz::radiosity
