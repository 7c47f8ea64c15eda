// The adaptive picture against the one traced in full, and its independence of everything but the scene.
#include "show/show.h"
#include "trace/adaptive.h"

#include <atomic>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

using namespace odraz;

namespace {

// Threads of the standard library: what the host's pool does, tested here without it.
struct Threads {
    Workers workers;
    int abort = 0;
    explicit Threads(int count) {
        workers = {count,
                   [](Workers &w, int pieces, void (*body)(void *, int, int), void *context) {
                       std::atomic<int> next{0};
                       std::vector<std::thread> all;
                       for (int t = 0; t < w.count; ++t)
                           all.emplace_back([&, t] {
                               for (int i; (i = next++) < pieces;) body(context, i, t);
                           });
                       for (std::thread &t : all) t.join();
                   },
                   &abort, nullptr};
    }
};

struct Picture {
    std::vector<unsigned char> memory;
    Frame frame;
    int64_t samples;
};

Picture traced(int scene, double row, const CameraKey &camera, const Quality &quality, int width, int height,
               int threads = 2) {
    Picture p;
    p.memory.resize(((size_t)width + 8) * (size_t)height * 16 + (size_t)threads * kTileScratchBytes + 8192 +
                    sizeof(Scene));
    Arena arena = {p.memory.data() + (64 - (uintptr_t)p.memory.data() % 64), p.memory.size() - 64, 0};
    Threads pool(threads);
    Tracer tracer;
    auto posed = std::make_unique<Scene>();
    posed->clear();
    kScenes[scene].pose(row, nullptr, *posed);
    posed->finish();
    EXPECT_TRUE(makeTracer(tracer, arena, threads) && makeFrame(p.frame, arena, width, height));
    View view = lookAt(camera.eye, camera.target, camera.roll, camera.fov, width, height);
    traceFrame(tracer, pool.workers, *posed, view, quality, p.frame);
    p.samples = tracedSamples(tracer);
    develop(p.frame, pool.workers, posed->exposure);
    return p;
}

double psnr(const Picture &a, const Picture &b) {
    double squares = 0;
    size_t bytes = (size_t)a.frame.width * (size_t)a.frame.height * 4;
    for (size_t i = 0; i < bytes; ++i) {
        double d = a.frame.rgba[i] - b.frame.rgba[i];
        squares += d * d;
    }
    return 10 * std::log10(255. * 255 * (double)bytes * 0.75 / squares);
}

constexpr CameraKey kTableView = {0, {2, 2.5f, 5.9f}, {0, 0.4f, 0}, 0, 36};
const Quality &named(QualityName name) { return kQualities[(int)name]; }

} // namespace

TEST(Adaptive, ComesNearTheReferenceInTheOrderOfTheQualities) {
    Picture reference = traced(kTable, 100, kTableView, named(QualityName::Reference), 320, 180);
    double draft = psnr(reference, traced(kTable, 100, kTableView, named(QualityName::Draft), 320, 180));
    double play = psnr(reference, traced(kTable, 100, kTableView, named(QualityName::Play), 320, 180));
    double film = psnr(reference, traced(kTable, 100, kTableView, named(QualityName::Film), 320, 180));
    EXPECT_GT(draft, 30);
    EXPECT_GT(play, draft + 3);
    EXPECT_GT(film, play + 2);
    EXPECT_GT(film, 40);
}

// The way that the governor takes: every step saves samples and costs accuracy, and none is large.
TEST(Adaptive, GoesFromFilmToDraftInSmallSteps) {
    Picture reference = traced(kTable, 100, kTableView, named(QualityName::Reference), 320, 180);
    double samples = 1e30, quality = 1e30;
    for (int i = 0; i <= 40; ++i) {
        float level = (float)i / 20;
        Quality q = level < 1 ? between(named(QualityName::Film), named(QualityName::Play), level)
                              : between(named(QualityName::Play), named(QualityName::Draft), level - 1);
        Picture p = traced(kTable, 100, kTableView, q, 320, 180);
        double db = psnr(reference, p), taken = (double)p.samples;
        EXPECT_LT(taken, samples * 1.02) << level;
        EXPECT_LT(db, quality + 0.3) << level;
        if (i) {
            EXPECT_GT(taken, samples * 0.6) << level;
            EXPECT_GT(db, quality - 1.5) << level;
        }
        samples = taken;
        quality = db;
    }
}

// Veins seen through glass are thinner than a coarse square; none of it may be missing in blocks.
TEST(Adaptive, ShowsTexturesInGlassAndMirrors) {
    CameraKey close = {0, {-0.2f, 0.8f, 2.2f}, {-0.38f, 0.5f, 0.1f}, 0, 36};
    Picture reference = traced(kPoint, 110, close, named(QualityName::Reference), 400, 225);
    Picture play = traced(kPoint, 110, close, named(QualityName::Play), 400, 225);
    int wrong = 0;
    for (int i = 0; i < 400 * 225 * 4; i += 4)
        wrong += std::abs(play.frame.rgba[i + 1] - reference.frame.rgba[i + 1]) > 40;
    EXPECT_LT(wrong, 60); // of 90,000; without the rule for textures there are 77
}

TEST(Adaptive, TakesFewerSamplesThanPixels) {
    Picture p = traced(kTable, 100, kTableView, named(QualityName::Play), 640, 360);
    EXPECT_LT((double)p.samples / (640 * 360), 0.5);
}

TEST(Adaptive, IsTheSameForEveryNumberOfThreads) {
    for (const Quality &q : {named(QualityName::Play), named(QualityName::Film)}) {
        Picture one = traced(kTable, 77, kTableView, q, 333, 187, 1);
        for (int threads : {2, 3, 7}) {
            Picture many = traced(kTable, 77, kTableView, q, 333, 187, threads);
            EXPECT_EQ(0, memcmp(one.frame.rgba, many.frame.rgba, 333 * 187 * 4)) << threads;
        }
    }
}

TEST(Adaptive, TakesEverySize) {
    for (auto [w, h] : {std::pair{1, 1}, {1, 64}, {7, 3}, {8, 8}, {9, 65}, {63, 64}, {130, 1}, {257, 129}})
        for (const Quality &q :
             {named(QualityName::Draft), named(QualityName::Play), named(QualityName::Film)}) {
            Picture p = traced(kFlake, 300, {0, {9, 5, 4}, {0, 1, -1}, 0, 34}, q, w, h);
            for (int y = 0; y < h; ++y)
                for (int x = 0; x < w; ++x)
                    for (float *plane : p.frame.plane)
                        ASSERT_TRUE(plane[y * p.frame.stride + x] >= 0) << w << "x" << h;
        }
}

// A field of balls 2 to 8 pixels wide on an 8-pixel grid: none may be lost.
TEST(Adaptive, LosesNothingSmall) {
    auto scene = std::make_unique<Scene>();
    scene->clear();
    Material m = {};
    m.emit = {1, 1, 1};
    scene->add(m);
    std::vector<std::pair<float, float>> at;
    for (int i = 0; i < 60; ++i) {
        float x = (float)(i % 10) * 0.9f - 4.1f + 0.013f * (float)i,
              y = (float)(i / 10) * 0.85f - 2.1f - 0.017f * (float)i, r = 0.011f + 0.0011f * (float)(i % 30);
        scene->add(sphere({x, y, 0}, r, 0));
        at.push_back({x, y});
    }
    scene->finish();
    std::vector<unsigned char> memory(640 * 368 * 16 + kTileScratchBytes + 8192);
    Arena arena = {memory.data() + (64 - (uintptr_t)memory.data() % 64), memory.size() - 64, 0};
    Workers workers = serialWorkers();
    Tracer tracer;
    Frame frame;
    ASSERT_TRUE(makeTracer(tracer, arena, 1) && makeFrame(frame, arena, 640, 360));
    View view = lookAt({0, 0, 10}, {0, 0, 0}, 0, 30, 640, 360);
    traceFrame(tracer, workers, *scene, view, named(QualityName::Play), frame);
    int lost = 0;
    for (auto [x, y] : at) {
        double scale = 180 / std::tan(15 * M_PI / 180) / 10;
        int px = (int)(320 + x * scale), py = (int)(180 - y * scale);
        if (px < 0 || py < 0 || px >= 640 || py >= 360) continue;
        lost += frame.plane[0][py * frame.stride + px] < 0.3f;
    }
    EXPECT_EQ(lost, 0);
}

TEST(Adaptive, AbortLeavesAtOnce) {
    Threads pool(2);
    pool.abort = 1;
    std::vector<unsigned char> memory(320 * 184 * 16 + 2 * kTileScratchBytes + 8192);
    Arena arena = {memory.data() + (64 - (uintptr_t)memory.data() % 64), memory.size() - 64, 0};
    Tracer tracer;
    Frame frame;
    ASSERT_TRUE(makeTracer(tracer, arena, 2) && makeFrame(frame, arena, 320, 180));
    auto posed = std::make_unique<Scene>();
    posed->clear();
    posed->finish();
    traceFrame(tracer, pool.workers, *posed, lookAt({}, {}, 0, 40, 320, 180), named(QualityName::Film),
               frame);
    EXPECT_EQ(tracedSamples(tracer), 0);
}
