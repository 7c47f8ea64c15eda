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
    : study(study), patches(*solved.patches), model(*patches.model), solution(solved.solution),
      rowSeconds(solved.report.seconds[(int)SolveStep::kFormFactors]), converged((size_t)model.patchCount) {
    System &s = patches.radiosity.system;
    odraz::solve(s, study.workers, 1e-6f, 300);
    for (int i = 0; i < model.patchCount; ++i) {
        Rgb b = converged[(size_t)i] = ofColumns(s.radiosity, i);
        double light = (double)luminance(b), a = (double)model.patches[i].area;
        all += light * light * a, power += light * a;
    }
}

Rgb Converging::ofColumns(const float *values, int patch) const {
    const float *v = values + (size_t)patch * (size_t)patches.radiosity.system.columns;
    return {v[0], v[4], v[8]};
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

Curve Converging::gathering() {
    Curve curve = {"gathering (in the next pass)", {}};
    System &s = patches.radiosity.system;
    std::fill_n(s.radiosity, (size_t)s.patches * (size_t)s.columns, 0.f);
    double seconds = rowSeconds, before = 0;
    for (int pass = 1; pass <= kMostPasses; ++pass) {
        study.tick();
        Stopwatch watch;
        bounce(s, study.workers);
        seconds += watch.processor();
        curve.steps.push_back(stepOf(
            pass, seconds, [&](int i) { return ofColumns(s.radiosity, i); }, before));
        if (curve.steps.back().error < kDone) break;
    }
    return curve;
}

Curve Converging::atOnce() {
    struct Told {
        Converging &own;
        Curve curve = {"Gauss-Seidel (at once)", {}};
        double spent = 0, before = 0;
        Stopwatch watch = {};
    } told = {*this};
    System &s = patches.radiosity.system;
    told.watch = {};
    odraz::solve(
        s, study.workers, 1e-7f, kMostPasses,
        {[](float, void *context) {
             Told &t = *(Told *)context;
             double took = t.watch.processor();
             const float *values = t.own.patches.radiosity.system.indirect; // where solve() keeps them
             Curve &c = t.curve;
             t.spent += took;
             c.steps.push_back(t.own.stepOf((int)c.steps.size() + 1, t.own.rowSeconds + t.spent,
                                            [&](int i) { return t.own.ofColumns(values, i); }, t.before));
             t.watch = {};
         },
         &told});
    auto done = std::find_if(told.curve.steps.begin(), told.curve.steps.end(),
                             [](const Step &s) { return s.error < kDone; });
    if (done != told.curve.steps.end()) told.curve.steps.erase(done + 1, told.curve.steps.end());
    return told.curve;
}

Curve Converging::shootingRows() {
    Curve curve = {"shooting over the rows", {}};
    const System &s = patches.radiosity.system;
    std::vector<Rgb> direct, none((size_t)model.patchCount);
    for (int i = 0; i < model.patchCount; ++i) direct.push_back(ofColumns(s.direct, i));
    Stopwatch watch;
    Columns columns(patches.radiosity.factors, model.patchCount);
    Shooting shooting(model, patchesAlone(model), none, direct);
    double seconds = rowSeconds + watch.processor(), before = 0;
    int shots = 0, next = 64;
    double most = 60. * model.patchCount;
    auto tell = [&] {
        if (!curve.steps.empty() && curve.steps.back().number == shots) return;
        curve.steps.push_back(stepOf(
            shots, seconds, [&](int i) { return shooting.radiosity(i); }, before));
    };
    while (shooting.left() > 1e-6 && shots < most) {
        study.tick();
        Stopwatch batch;
        for (int k : shooting.brightest(64)) {
            Shooting::Shot shot = shooting.take(k);
            shooting.handOut(shot.power * (1 / model.patches[shot.patch].area), columns.of(shot.patch));
            ++shots;
        }
        seconds += batch.processor();
        if (shots < next) continue;
        next = shots + shots / 4;
        tell();
        if (curve.steps.back().error < kDone) break;
    }
    if (shots > 0) tell();
    return curve;
}

Curve Converging::shooting(int px, double limit, bool blocks) {
    Curve curve = {blocks ? "shooting by hemicubes, blocks" : "shooting by hemicubes, single patches", {}};
    std::vector<Rgb> emits, direct;
    // What the rows brought from the lamps is shot here: only what comes from outside is direct
    const System &s = patches.radiosity.system;
    std::vector<float> seen = lampsSeen();
    for (int i = 0; i < model.patchCount; ++i) {
        emits.push_back(solution.emits[(size_t)model.patches[i].chart]);
        Rgb arrives = ofColumns(s.direct, i) - ofColumns(seen.data(), i);
        direct.push_back({std::max(arrives.x, 0.f), std::max(arrives.y, 0.f), std::max(arrives.z, 0.f)});
    }
    Stopwatch clock;
    // As many blocks as let each shoot some times
    int shotsAllowed = (int)std::clamp(limit / std::max(study.hemicubeSeconds(px), 1e-6), 16., 1e6);
    Shooters shooters =
        blocks ? blocksOfPatches(model, emits, std::max(shotsAllowed / 4, 1)) : patchesAlone(model);
    Shooting shooting(model, std::move(shooters), emits, direct);
    HemicubeShooter shooter(study.gl, model, px, 0);
    double seconds = 0, before = 0;
    int shots = 0, next = 16;
    auto tell = [&] {
        if (!curve.steps.empty() && curve.steps.back().number == shots) return;
        curve.steps.push_back(stepOf(
            shots, seconds, [&](int i) { return shooting.radiosity(i); }, before));
    };
    while (shooting.left() > 1e-4) {
        study.tick();
        if (clock.wall() >= limit) curve.stopped = true;
        if (curve.stopped) break;
        Stopwatch batch;
        int shot = shooter.shoot(shooting, shooter.batch(), study.workers);
        if (shot == 0) break;
        shots += shot, seconds += batch.processor();
        if (shots < next) continue;
        next = shots + shots / 4;
        tell();
    }
    if (shots > 0) tell();
    return curve;
}

std::vector<float> Converging::lampsSeen() const {
    size_t columns = (size_t)patches.radiosity.system.columns, count = (size_t)model.patchCount * columns;
    std::vector<float> lamps(count), seen(count);
    for (size_t i = 0; i < (size_t)model.patchCount; ++i) {
        Rgb e = solution.emits[(size_t)model.patches[i].chart];
        lamps[i * columns] = e.x, lamps[i * columns + 4] = e.y, lamps[i * columns + 8] = e.z;
    }
    findIndirect(patches.radiosity.factors, model.patchCount, (int)columns, lamps.data(), seen.data(),
                 study.workers);
    return seen;
}

} // namespace odraz::radiosity
