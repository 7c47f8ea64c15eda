#include "tools/radiosity/view_growth.h"

#include "tools/common/clock.h"
#include "tools/common/machine.h"
#include "tools/radiosity/growing.h"

#include <cstdio>

namespace odraz {

ViewGrowth::ViewGrowth(Mesh mesh, BakeSettings settings, const RenderSettings &camera, void (*wake)())
    : mesh(std::move(mesh)), settings(std::move(settings)), camera(camera), wake(wake) {
    this->settings.looks = [this] { return looks(); };
    this->settings.growing = [this](const Bake &b, const float *radiosity) { look(b, radiosity); };
    std::unique_lock held(lock);
    thread = std::thread([this] { run(); });
    opened.wait(held, [this] { return open; });
}

ViewGrowth::~ViewGrowth() {
    stop();
    thread.join();
}

void ViewGrowth::run() {
    auto tell = [this](auto change) {
        std::lock_guard held(lock);
        change();
        open = true;
        opened.notify_one();
    };
    try {
        Gl gl = openGl();
        Workers workers = allProcessors();
        tell([] {});
        auto b =
            bake(mesh, settings, gl, workers, &stopped, [&](const char *step, float done, float residual) {
                if (!step) return;
                char text[80], left[40] = "";
                if (residual >= 0) std::snprintf(left, sizeof left, ", residual %.1e", (double)residual);
                std::snprintf(text, sizeof text, "%s %.0f %%%s", step, (double)done * 100, left);
                tell([&] { does = text; });
            });
        auto solved = std::make_unique<Baked>(*b);
        bool geometry = !baked || baked->texels.size() != solved->texels.size() ||
                        baked->cells.size() != solved->cells.size();
        baked = std::move(solved);
        tell([&] { news.notes = b->notes; });
        b.reset();
        hand(geometry, true);
        tell([&] { does = ""; });
    } catch (...) {
        tell([this] { wrong = std::current_exception(); });
    }
    wake();
}

// Making light that is asked for then is part of looking.
bool ViewGrowth::looks() {
    if (wallSeconds() < next || __atomic_load_n(&stopped, __ATOMIC_RELAXED)) return false;
    if (!looking) began = wallSeconds();
    return looking = true;
}

void ViewGrowth::look(const Bake &b, const float *radiosity) {
    if (!looks()) return;
    bool first = !baked;
    if (first) baked = std::make_unique<Baked>(b);
    baked->light = lightSoFar(b, radiosity);
    hand(first, false);
    // A fifth of the time at most: small models show every sweep
    double end = wallSeconds();
    next = end + 4 * (end - began);
    looking = false;
    wake();
}

void ViewGrowth::hand(bool geometry, bool done) {
    if (geometry) {
        shown = std::make_shared<ViewMesh>(*baked);
        placeCamera(*baked, camera);
    }
    auto light = std::make_shared<const std::vector<Rgb>>(shown->light(*baked));
    std::lock_guard held(lock);
    if (geometry) news.mesh = shown, news.camera = camera;
    news.light = std::move(light);
    news.done = done;
    ++news.pictures;
}

ViewNews ViewGrowth::take() {
    std::lock_guard held(lock);
    if (wrong) std::rethrow_exception(wrong);
    ViewNews taken = news;
    news.mesh = nullptr, news.light = nullptr;
    return taken;
}

std::string ViewGrowth::step() {
    std::lock_guard held(lock);
    return does;
}

} // namespace odraz
