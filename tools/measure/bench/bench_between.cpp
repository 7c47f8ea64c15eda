// bench_between: in-betweens, compared with `draft` and `play` traced at the same moment.
//
//   build/bench_between [--size WxH] [--step SECONDS] [SECONDS...]
// For every moment of the film (default: three of each scene) it traces two pictures at `play`, 1/60 s before
// and after, and makes the picture between them. It writes a CSV: PSNR against 64 samples in every pixel, in
// linear light (exposed, clipped at 1) and as shown (film curve and sRGB); milliseconds of one thread; the
// share of pixels that was traced again.
#include "inside.h"
#include "tools/common/arguments.h"
#include "tools/common/clock.h"
#include "tools/common/heap_arena.h"
#include "tools/common/machine.h"
#include "trace/picture/development.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace odraz;

namespace {

constexpr char kUsage[] = "usage: bench_between [--size WxH] [SECONDS...]\n";
constexpr double kStep = 1 / 60.0;

using Planes = std::vector<float>;

Planes planesOf(const Frame &f) {
    Planes all;
    for (const float *p : f.plane)
        for (int y = 0; y < f.height; ++y)
            all.insert(all.end(), p + (size_t)y * (size_t)f.stride,
                       p + (size_t)y * (size_t)f.stride + f.width);
    return all;
}

struct Decibels {
    double linear, shown;
};
Decibels compare(const Planes &a, const Planes &truth, float exposure) {
    double linear = 0, shown = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        double d = std::fmin(a[i] * exposure, 1.f) - std::fmin(truth[i] * exposure, 1.f);
        linear += d * d;
        auto show = [&](float v) { return encodeSrgb(filmic(broadcast(v * exposure)))[0]; };
        d = show(a[i]) - show(truth[i]);
        shown += d * d;
    }
    auto decibels = [&](double sum) { return -10 * std::log10(sum / (double)a.size() + 1e-12); };
    return {decibels(linear), decibels(shown)};
}

struct Asked {
    int width = 1280, height = 720;
    bool once = false; // one run, for programs that count instructions
    std::vector<double> moments;
};

Asked read(Arguments &words) {
    Asked asked;
    while (const char *word = words.next()) {
        std::string option = word;
        if (option == "--once")
            asked.once = true;
        else if (option != "--size") {
            char *end;
            asked.moments.push_back(std::strtod(word, &end));
            if (end == word || *end) words.refuse(option);
        } else if (std::sscanf(words.value(option).c_str(), "%dx%d", &asked.width, &asked.height) != 2)
            words.refuse(option);
    }
    if (asked.moments.empty())
        asked.moments = {8,  11.5, 16,  20,  30,  44,  52,  64,  70.5, 76, 84,
                         93, 98,   108, 121, 131, 138, 144, 150, 156,  159};
    return asked;
}

// The two pictures that another is made between
void pictureBoth(Intro &intro, double s) {
    const Quality &play = kQualities[(int)QualityName::Play];
    picture(intro, 0, s - kStep, play);
    picture(intro, 1, s + kStep, play);
}

// One row of the CSV
void measure(Intro &intro, double s, Workers &workers) {
    const Quality &play = kQualities[(int)QualityName::Play], &draft = kQualities[(int)QualityName::Draft];
    Quality truth = kQualities[(int)QualityName::Reference];
    truth.depth = 8, truth.cutoff = 1 / 256.f;
    int width = intro.frame.width, height = intro.frame.height;
    Film film = intro.film;
    float exposure = 1;
    auto trace = [&](const Quality &q, double &ms) {
        View view = poseAt(film, s).view(width, height);
        exposure = film.scene->exposure;
        double began = threadSeconds();
        traceFrame(intro.tracer, workers, *film.scene, view, q, intro.frame);
        ms = (threadSeconds() - began) * 1e3;
        return planesOf(intro.frame);
    };
    double ms[4] = {1e9, 0, 0, 0};
    Planes exact = trace(truth, ms[3]), cheap = trace(draft, ms[1]), dear = trace(play, ms[2]);
    pictureBoth(intro, s);
    Traced now = {intro.frame, film.scene, poseAt(film, s).view(width, height)};
    constexpr int kTries = 3; // the fastest counts
    for (int i = 0; i < kTries; ++i) {
        double began = threadSeconds();
        traceBetween(intro.between, intro.tracer, workers, intro.slots[0].traced, intro.slots[1].traced, play,
                     now);
        ms[0] = std::fmin(ms[0], (threadSeconds() - began) * 1e3);
    }
    Decibels a = compare(planesOf(intro.frame), exact, exposure), b = compare(cheap, exact, exposure),
             c = compare(dear, exact, exposure);
    std::printf("%s,%g,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.1f,%.1f,%.1f,%.4f\n", sceneName(sceneAt(s)), s,
                a.linear, b.linear, c.linear, a.shown, b.shown, c.shown, ms[0], ms[1], ms[2],
                (double)tracedAnew(intro.between) / kTries / (width * height));
    std::fflush(stdout);
}

int run(Arguments &words) {
    Asked asked = read(words);
    bool hall = false;
    for (double s : asked.moments) hall |= needsHall(s - kStep, s + kStep);
    IntroSettings settings = {asked.width, asked.height};
    settings.pairs = true;
    Workers workers = serialWorkers();
    HeapArena memory(memoryNeeded(settings, 1, hall));
    Gl gl = hall ? openGl() : Gl{};
    Intro *intro;
    if (const char *wrong = load(intro, settings, memory.arena, workers, hall ? &gl : nullptr))
        throw std::runtime_error(wrong);
    if (!asked.once)
        std::printf("scene,seconds,between_linear,draft_linear,play_linear,between_shown,draft_shown,"
                    "play_shown,between_ms,draft_ms,play_ms,anew\n");
    for (double s : asked.moments)
        if (asked.once) {
            pictureBoth(*intro, s);
            between(*intro, 0, 1);
        } else
            measure(*intro, s, workers);
    return 0;
}

} // namespace

int main(int argc, char **argv) { return runProgram("bench_between", kUsage, argc, argv, run); }
