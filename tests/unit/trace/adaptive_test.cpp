// Compares adaptive pictures with pictures traced in full. (test_pictures.py tests that they are the same for
// every number of threads.)
#include "show/scenes.h"
#include "tests/support/figure.h"
#include "tests/support/sanitized.h"
#include "tests/support/traced_picture.h"
#include "tools/measure/bench/peer_scenes.h"
#include "trace/rays/beam.h"

using namespace odraz;
using namespace odraz::measure;

FIGURES_TEST(Adaptive, ComesNearTheReferenceInTheOrderOfTheQualities) {
    TracedPicture reference = traced(kTable, 100, kTableView, named(QualityName::Reference), 640, 360);
    auto of = [&](QualityName name) {
        TracedPicture p = traced(kTable, 100, kTableView, named(name), 640, 360);
        EXPECT_TRUE(p.samples < 640 * 360 || name == QualityName::Film) << p.samples;
        return decibels(reference, p);
    };
    double draft = of(QualityName::Draft), play = of(QualityName::Play), film = of(QualityName::Film);
    EXPECT_GT(draft, 30);
    EXPECT_GT(play, draft + 1);
    EXPECT_GT(film, play + 1);
    EXPECT_GT(film, 36); // at this size crystals and boards have detail finer than a pixel
}

// The governor's steps between qualities are small, and each saves samples and costs accuracy.
FIGURES_TEST(Adaptive, GoesFromFilmToDraftInSmallSteps) {
    TracedPicture reference = traced(kTable, 100, kTableView, named(QualityName::Reference), 320, 180);
    double samples = 1e30, quality = 1e30;
    for (int i = 2; i <= 40; ++i) { // starts at level 0.1, because only `film` has some features
        float level = (float)i / 20;
        Quality q = level < 1 ? blend(named(QualityName::Film), named(QualityName::Play), level)
                              : blend(named(QualityName::Play), named(QualityName::Draft), level - 1);
        TracedPicture p = traced(kTable, 100, kTableView, q, 320, 180);
        double db = decibels(reference, p), taken = (double)p.samples;
        EXPECT_LT(taken, samples * 1.02) << level;
        EXPECT_LT(db, quality + 0.3) << level;
        if (i > 2) {
            EXPECT_GT(taken, samples * 0.5)
                << level; // 0.55 at the level where squares of a quarter of a pixel end
            EXPECT_GT(db, quality - 1.5) << level;
        }
        samples = taken;
        quality = db;
    }
}

// Veins seen through glass are thinner than a coarse square, but no block of them may be missing. A viewer
// does not notice one wrong pixel of two hundred along veins that are a pixel wide.
FIGURES_TEST(Adaptive, ShowsTexturesInGlassAndMirrors) {
    CameraKey close = {0, {-0.62f, 0.8f, 2.7f}, {-0.8f, 0.5f, 0.6f}, 0, 36};
    TracedPicture reference = traced(kPoint, 72, close, named(QualityName::Reference), 400, 225);
    TracedPicture play = traced(kPoint, 72, close, named(QualityName::Play), 400, 225);
    int wrong = 0;
    for (int i = 0; i < 400 * 225; ++i) wrong += std::abs(play.at(i, 1) - reference.at(i, 1)) > 40;
    EXPECT_LT(wrong, 400 * 225 / 200);
}

TEST(Adaptive, TakesEverySize) {
    for (auto [w, h] : {std::pair{1, 1}, {1, 64}, {7, 3}, {8, 8}, {9, 65}, {63, 64}, {130, 1}, {257, 129}})
        for (const Quality &q :
             {named(QualityName::Draft), named(QualityName::Play), named(QualityName::Film)}) {
            TracedPicture p = traced(kFlake, 300, {0, {9, 5, 4}, {0, 1, -1}, 0, 34}, q, w, h);
            for (float v : planesOf(p.frame)) ASSERT_TRUE(v >= 0) << w << "x" << h;
        }
}

// Compares the shape shown in every pixel with rays through the pixels' middles: no small shape is lost or
// misplaced. Compares interpolated pixels with the same quality without squares wider than a pixel.
TEST(Adaptive, EachPixelShowsTheShapeInItsMiddle) {
    struct {
        const char *name;
        void (*pose)(Scene &);
        CameraKey camera;
    } const scenes[] = {
        {"A", posePeerA, kPeerCameraA},
        {"B", [](Scene &s) { posePeerB(s); }, kPeerCameraB},
        {"field", poseField, kFieldCamera},
        {"flake",
         [](Scene &s) {
             poseFlake({130, scripted(kFlake, 130), nullptr, {}}, s);
         },
         {0, {2.2f, 1.9f, 1.6f}, {0, 1, 0}, 0, 40}},
    };
    constexpr int kWidth = 1280, kHeight = 720;
    for (auto &[name, pose, camera] : scenes) {
        if (kSanitized && pose != posePeerA) continue;
        auto scene = emptyScene();
        pose(*scene);
        scene->finish();
        TracedPicture p = traced(*scene, camera, named(QualityName::Play), kWidth, kHeight, 2, true);
        View view = lookAt(camera.eye, camera.target, camera.roll, camera.fov, kWidth, kHeight);
        int wrong = 0, compared = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; x += 8) {
                Vec3x8 d = normalize(
                    view.direction(toFloat(kLanes) + ((float)x + 0.5f), broadcast((float)y + 0.5f)));
                Hit8 hit = intersect(*scene, {broadcast(view.eye), d}, kLanes >= 0);
                for (int k = 0; k < 8; ++k) {
                    uint16_t shape = p.shapes[(size_t)(y * p.frame.stride + x + k)];
                    if (shape == kManyShapes) continue;
                    ++compared;
                    wrong += shape != (hit.shape[k] < 0 ? kSkyShown : (uint16_t)hit.shape[k]);
                }
            }
        expectAtMost(std::string(name) + ": wrong pixels", wrong, 0);
        EXPECT_GT(compared, kWidth * kHeight / 4) << name;

        Quality fine = named(QualityName::Play);
        fine.coarse = 4;
        TracedPicture full = traced(*scene, camera, fine, kWidth, kHeight);
        int off = 0;
        for (int i = 0; i < kWidth * kHeight; ++i) {
            auto differs = [&](int c) { return std::abs(p.at(i, c) - full.at(i, c)) > 16; };
            off += differs(0) || differs(1) || differs(2);
        }
        expectAtMost(std::string(name) + ": pixels off, %", 100. * off / (kWidth * kHeight), 0.05);
    }
}

TEST(Adaptive, TakesTheLargestFrame) {
    auto scene = emptyScene();
    posePeerA(*scene);
    scene->finish();
    auto sumAt = [&](int part) { // the picture has 1 / part of the width and the height
        TracedPicture p =
            traced(*scene, kPeerCameraA, named(QualityName::Draft), kMaxWidth / part, kMaxHeight / part);
        double sum = 0;
        for (float v : planeOf(p.frame, 1)) {
            EXPECT_GE(v, 0);
            sum += v;
        }
        return sum;
    };
    EXPECT_NEAR(sumAt(1) / 256 / sumAt(16), 1, 0.01);
}

TEST(Adaptive, AbortLeavesAtOnce) {
    Threads pool(2);
    pool.abort = 1;
    HeapArena memory(320 * 184 * 16 + 2 * kTileScratchBytes + 8192);
    Tracer tracer;
    Frame frame;
    ASSERT_TRUE(makeTracer(tracer, memory.arena, 2) && makeFrame(frame, memory.arena, 320, 180));
    auto posed = emptyScene();
    posed->finish();
    traceFrame(tracer, pool.workers, *posed, lookAt({}, {}, 0, 40, 320, 180), named(QualityName::Film),
               frame);
    EXPECT_EQ(tracedSamples(tracer), 0);
}

// Whether a mirrored texture splits squares depends on its brightness in the picture, not on the strength of
// the mirror alone.
TEST(Adaptive, TakesFewSamplesWhereMirroredTexturesAreDark) {
    auto samples = [](float strength) {
        auto s = emptyScene();
        s->add(Material{.reflect = 0.8f});
        Material wall = matte({1, 1, 1});
        wall.texture = {
            Pattern::Marble, 8, {{0.2f, 0.2f, 0.2f}, {0.4f, 0.4f, 0.4f}, {0.6f, 0.6f, 0.6f}, {1, 1, 1}}};
        s->add(wall);
        s->add(plane({0, 0, 0}, 0));
        s->add(box({0, 2, -6}, {6, 2, 0.1f}, 1));
        s->ambientLow = s->ambientHigh = Rgb{1, 1, 1} * strength;
        s->finish();
        return traced(*s, {0, {0, 4, 6}, {0, -1, 0}, 0, 36}, named(QualityName::Draft), 320, 180).samples;
    };
    int64_t bright = samples(0.5f), dark = samples(0.01f);
    EXPECT_LT(dark * 2, bright); // sides with little change are not traced
}
