// What transfer costs: at start-up, step by step, and in every frame; and how exact the relit hall is over
// the day.
#include "tools/measure/measured.h"
#include "tools/measure/transfer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace odraz;

namespace {

// When the steps of a solution end, by what it tells of its progress.
struct Clock {
    struct Step {
        const char *name;
        float end;
        double seconds;
    };
    std::vector<Step> steps = {
        {"elements", 0.05f, 0},       {"hemicubes, form factors", 0.635f, 0}, {"direct light", 0.8f, 0},
        {"finer elements", 0.92f, 0}, {"bounces of all bases", 0.965f, 0},    {"to the elements", 1, 0}};
    size_t now = 0;
    double last = processorSeconds();

    Progress progress() {
        return {[](float done, void *p) {
                    Clock &c = *(Clock *)p;
                    while (c.now < c.steps.size() && done >= c.steps[c.now].end - 1e-4f) {
                        double t = processorSeconds();
                        c.steps[c.now++].seconds = t - c.last;
                        c.last = t;
                    }
                },
                this};
    }
};

void startUp(const Gl &gl, Workers &workers, std::unique_ptr<SolvedHall> &solved) {
    std::vector<std::vector<double>> times(8);
    std::vector<const char *> names;
    OwnArena memory((size_t)64 << 20);
    for (int round = 0; round < 5; ++round) {
        Clock clock;
        solved =
            std::make_unique<SolvedHall>(kHallSettings, gl, workers, kRoomBytes, nullptr, clock.progress());
        names.clear();
        // The first step begins when the memory is there
        clock.steps[0].seconds = solved->seconds;
        for (size_t i = 1; i < clock.steps.size(); ++i) clock.steps[0].seconds -= clock.steps[i].seconds;
        for (size_t i = 0; i < clock.steps.size(); ++i) {
            times[i].push_back(clock.steps[i].seconds);
            names.push_back(clock.steps[i].name);
        }
        for (int pca = 0; pca < 2; ++pca) {
            memory = OwnArena((size_t)64 << 20);
            GlossySettings settings;
            if (!pca) settings.pca = {.clusters = 1, .dimensions = 0, .rounds = 0};
            double began = processorSeconds();
            solved->polish(settings, memory.arena, workers);
            double took = processorSeconds() - began;
            times[(size_t)(6 + pca)].push_back(pca ? took - times[6].back() : took);
        }
    }
    names.push_back("the floor's matrices");
    names.push_back("their clustered PCA");
    const Hall &hall = *solved->hall;
    std::printf("start-up, processor seconds, the median of five: %d elements, %d patches, %d bases\n",
                hall.model.texelCount, hall.model.patchCount, hall.radiosity.lights.bases());
    double sum = 0;
    for (size_t i = 0; i < times.size(); ++i) {
        std::sort(times[i].begin(), times[i].end());
        std::printf("  %-26s %.3f\n", names[i], times[i][2]);
        sum += times[i][2];
    }
    std::printf("  %-26s %.3f\n", "all", sum);
}

void everyFrame(SolvedHall &solved, Workers &workers) {
    const Hall &hall = *solved.hall;
    int texels = hall.model.texelCount;
    TexelPlanes planes(texels);
    OwnArena memory((size_t)64 << 20);
    solved.polish({}, memory.arena, workers);

    std::printf("a frame, ms of one thread\n");
    auto show = [&](const char *name, const HallLight &light) {
        LightVector v;
        double vector = medianMs([&] { v = lightVector(light); }),
               rows = medianMs([&] { relight(hall.radiosity, hall.model, v, planes.plane); }),
               floor = medianMs([&] {
                   relightGlossy(hall.gloss, v, {3, 1.55f, 3}, 0.06f, 1);
               });
        std::printf("  %-26s light vector %.3f, relight %.3f (%.3f for 8,000 elements), gloss %.3f\n", name,
                    vector, rows, rows * 8000 / texels, floor);
    };
    show("noon", {kNoon, {}, {}, 1});
    show("three lanterns, night", {kHours - 1, {1, 1, 1}, {}, 1});
    show("door of light, night", {kHours - 1, {}, {1, 1, 1, 1, 1, 1, 1, 1}, 1});

    std::printf("rows of elements, one way or the other\n");
    for (bool suns : {false, true}) {
        TransferRows rows = rowsOf(solved, suns);
        std::vector<float> light((size_t)rows.columns, 1.f);
        std::printf("  %d x %d%s: uncompressed %.1f MB\n", rows.rows, rows.columns, suns ? ", with suns" : "",
                    (double)rows.data.size() * 4e-6);
        for (PcaSettings s :
             {PcaSettings{.clusters = 64, .dimensions = 8}, PcaSettings{.clusters = 64, .dimensions = 16},
              PcaSettings{.clusters = 64, .dimensions = 24},
              PcaSettings{.clusters = 128, .dimensions = 24}}) {
            Compressed c = compressed(rows, blocksOf(hall.model, s.clusters), s, workers);
            double ms = medianMs([&] { relightRows(c.pca, light.data(), planes.plane); });
            std::printf("  %3d clusters x %2d: error %.2f %%, %.1f MB, start-up %.3f s, relight %.3f ms "
                        "(%.3f for 8,000)\n",
                        s.clusters, s.dimensions, c.errorPercent, (double)c.bytes() * 1e-6, c.seconds, ms,
                        ms * 8000 / rows.rows);
        }
    }
}

} // namespace

int main(int argc, char **argv) {
    if (argc > 1) {
        std::fprintf(stderr, "usage: bench_transfer (it cannot use '%s')\n", argv[1]);
        return 2;
    }
    Gl gl;
    Workers workers;
    try {
        openAll(gl, workers);
        std::unique_ptr<SolvedHall> solved;
        startUp(gl, workers, solved);
        everyFrame(*solved, workers);
        solved.reset();
        std::printf("the relit hall against solutions for that very sky and sun, rms %%: in the lightmap; "
                    "with the sun itself\n");
        std::vector<float> hours;
        for (int i = 0; i < 2 * kHours - 1; ++i) hours.push_back((float)i * 0.5f + (i % 2 ? 0.125f : 0));
        for (const DayError &e : dayErrors(hours, {kBands}, gl, workers))
            std::printf("  hour %.3f%s: %.2f; %.2f\n", (double)e.hour,
                        std::fmod(e.hour, 0.25f) == 0 ? "" : ", between suns", e.lightmap, e.whole);
    } catch (const std::runtime_error &e) {
        std::fprintf(stderr, "bench_transfer: %s\n", e.what());
        return 1;
    }
}
