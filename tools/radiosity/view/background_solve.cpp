#include "tools/radiosity/view/background_solve.h"

#include "tools/common/clock.h"
#include "tools/common/text.h"
#include "tools/radiosity/solve/solve.h"
#include "tools/support/machine.h"

namespace odraz::radiosity {

BackgroundSolve::BackgroundSolve(Mesh mesh, SolveSettings settings, const RenderSettings &camera,
                                 void (*wake)())
    : mesh(std::move(mesh)), settings(std::move(settings)), camera(camera), wake(wake) {
    this->settings.watcher = [this](const auto &light) { watch(light); };
    thread = std::jthread([this] { run(); });
    opened.acquire();
}

void BackgroundSolve::run() {
    auto change = [this](auto how) {
        std::lock_guard held(lock);
        how();
    };
    try {
        Gl gl = openGl();
        Workers workers = allProcessors();
        opened.release();
        auto progress = [&](const char *step, float done, float residual) {
            std::string text = common::format("%s %.0f %%", step, (double)done * 100);
            if (residual >= 0) common::append(text, ", residual %.1e", (double)residual);
            change([&] { currentStep = text; });
        };
        Solved solved = solveModel(mesh, settings, gl, workers, &stopped, progress);
        bool geometry = !solution || solution->texels.size() != solved.solution.texels.size() ||
                        solution->cells.size() != solved.solution.cells.size();
        solution = std::make_unique<Solution>(std::move(solved.solution));
        change([&] { news.notes = solved.report.notes; });
        solved = {};
        publish(geometry, true);
        change([&] { currentStep = ""; });
    } catch (...) {
        change([this] { error = std::current_exception(); });
        opened.release();
    }
    wake();
}

void BackgroundSolve::watch(const std::function<const Solution &()> &light) {
    double began = common::wallSeconds();
    if (began < next || __atomic_load_n(&stopped, __ATOMIC_RELAXED)) return;
    const Solution &soFar = light();
    bool first = !solution;
    if (first)
        solution = std::make_unique<Solution>(soFar);
    else
        solution->light = soFar.light;
    publish(first, false);
    // Spend at most a fifth of the time on computing light. Small models show every sweep
    double end = common::wallSeconds();
    next = end + 4 * (end - began);
    wake();
}

void BackgroundSolve::publish(bool geometry, bool done) {
    if (geometry) {
        shown = std::make_shared<ViewMesh>(*solution);
        placeCamera(*solution, camera);
    }
    auto light = std::make_shared<const std::vector<Rgb>>(shown->light(*solution));
    std::lock_guard held(lock);
    if (geometry) news.mesh = shown, news.camera = camera;
    news.light = std::move(light);
    news.done = done;
}

SolveNews BackgroundSolve::takeNews() {
    std::lock_guard held(lock);
    if (error) std::rethrow_exception(error);
    SolveNews taken = news;
    news.mesh = nullptr, news.light = nullptr;
    return taken;
}

std::string BackgroundSolve::step() {
    std::lock_guard held(lock);
    return currentStep;
}

} // namespace odraz::radiosity
