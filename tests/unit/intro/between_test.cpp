// Tests in-betweens: they are close to the truth, closer than a cheap traced picture, and the same with any
// number of threads.
#include "inside.h"
#include "show/materials.h"
#include "tests/support/loaded_film.h"
#include "tests/support/pictures.h"
#include "tests/support/sanitized.h"
#include "tools/picture/psnr.h"

using namespace odraz;

constexpr int kWidth = 320, kHeight = 180;
constexpr double kStep = 1 / 60.0;

static Intro &film() {
    static LoadedFilm loaded(2, kWidth, kHeight, true, &headlessGl());
    return *loaded.intro;
}

// The samples a pixel of the last picture. In-betweens take none where they reuse other pictures.
static double samplesPerPixel() { return (double)tracedSamples(film().tracer) / (kWidth * kHeight); }

// Returns the radiance of a traced picture, before the letters are drawn.
static std::vector<float> traced(Intro &intro, double seconds, const Quality &quality) {
    View view = poseAt(intro.film, seconds).view(kWidth, kHeight);
    traceFrame(intro.tracer, *intro.workers, *intro.film.scene, view, quality, intro.frame);
    return planesOf(intro.frame);
}
// Returns the radiance of an in-between. Its two pictures are `gap` sixtieths apart, and the first one is
// `before` sixtieths earlier.
static std::vector<float> made(Intro &intro, double seconds, double gap = 2, double before = 1) {
    picture(intro, 0, seconds - before * kStep, named(QualityName::Play));
    picture(intro, 1, seconds + (gap - before) * kStep, named(QualityName::Play));
    Traced now = {intro.frame, intro.film.scene, poseAt(intro.film, seconds).view(kWidth, kHeight)};
    traceBetween(
        intro.between, intro.tracer, *intro.workers,
        {intro.slots[0].traced, intro.slots[1].traced, gap > 0 ? (float)(before / gap) : 0.5f, (float)gap},
        now, named(QualityName::Play));
    return planesOf(intro.frame);
}

using Bytes = std::vector<uint8_t>;

// PSNR in linear light, exposed and clipped at white.
static double decibels(const Intro &intro, const std::vector<float> &a, const std::vector<float> &b) {
    double squares = 0, exposure = intro.film.scene->exposure;
    for (size_t i = 0; i < a.size(); ++i) {
        double d = std::fmin(a[i] * exposure, 1) - std::fmin(b[i] * exposure, 1);
        squares += d * d;
    }
    return -10 * std::log10(squares / (double)a.size() + 1e-12);
}

// A picture of `play` and an in-between take about as long as two drafts, so they must not look worse: their
// mean squared error is at most half a dB above a draft's (in the credits), or too small to see.
FIGURES_TEST(Between, PairsAreNearerToTheTruthThanDrafts) {
    // (Not on beats, on which light changes at once)
    for (double seconds : {10.3, 22.3, 45.3, 54.3, 74.3, 90.3, 106.3, 138.3, 153.3}) {
        auto truth = traced(film(), seconds, named(QualityName::Reference));
        double draft = decibels(film(), truth, traced(film(), seconds, named(QualityName::Draft)));
        double play = decibels(film(), truth, traced(film(), seconds, named(QualityName::Play)));
        double samples = samplesPerPixel();
        double between = decibels(film(), truth, made(film(), seconds));
        double taken = samplesPerPixel() / samples;
        double pair = -10 * std::log10((std::pow(10, -play / 10) + std::pow(10, -between / 10)) / 2);
        EXPECT_GT(pair, std::fmin(draft - 0.5, 42)) << seconds; // above that no difference is seen
        EXPECT_LT(taken, 0.4) << seconds; // otherwise a traced picture would be as cheap
    }
}

TEST(Between, OfTwoEqualPicturesIsThatPicture) {
    std::vector<double> moments = {14, 30, 56, 138, 146};
    if (kSanitized) moments.resize(1);
    for (double seconds : moments) {
        auto play = traced(film(), seconds, named(QualityName::Play));
        EXPECT_GT(decibels(film(), play, made(film(), seconds, 0, 0)), 36) << seconds;
        EXPECT_LT(samplesPerPixel(), 0.12) << seconds; // at most three in one pixel of 25
    }
}

// A ball that rolls on the spot always looks the same, even if its mirror is slightly dull.
TEST(Between, ReflectionsDoNotRollWithABall) {
    Intro &intro = film();
    View view = lookAt({0, 1.2f, 4}, {0, 0.8f, 0}, 0, 40, kWidth, kHeight);
    auto pose = [&](Scene &scene, float turn) {
        scene.clear();
        scene.sky = duskSky(0);
        scene.ambientLow = scene.ambientHigh = {0.8f, 0.8f, 0.8f};
        scene.add(plane({}, scene.add(kBoards)));
        Shape *ball = scene.add(sphere({0, 0.8f, 0}, 0.8f, scene.add(kMirror)));
        ball->frame = {{1, 0, 0}, {0, std::cos(turn), std::sin(turn)}, {0, -std::sin(turn), std::cos(turn)}};
        scene.finish();
    };
    auto trace = [&](Traced to, float turn) {
        pose(*to.scene, turn);
        traceFrame(intro.tracer, *intro.workers, *to.scene, view, named(QualityName::Play), to.frame);
        if (to.frame.quads) markQuads(to.frame, *intro.workers);
        return Traced{to.frame, to.scene, view};
    };
    Traced now = {intro.frame, intro.film.scene, view};
    auto still = planesOf(trace(now, 0).frame);
    constexpr float kTurn = 0.045f; // the fastest turn of the largest ball of scene odraz
    Traced before = trace(intro.slots[0].traced, -kTurn), after = trace(intro.slots[1].traced, kTurn);
    traceBetween(intro.between, intro.tracer, *intro.workers, {before, after, 0.5f, 2}, now,
                 named(QualityName::Play));
    double alike = decibels(intro, still, planesOf(now.frame));
    EXPECT_GT(alike, 50);
    EXPECT_LT(samplesPerPixel(), 0.01);
}

// At any fraction of a wider gap the squared error is at most twice a draft's, or too small to see. Twice
// the error is not visible in a picture that is shown for a sixtieth of a second.
FIGURES_TEST(Between, IsNearAtEveryFraction) {
    for (double seconds : {20., 44., 98., 150.}) {
        auto truth = traced(film(), seconds, named(QualityName::Reference));
        double draft = decibels(film(), truth, traced(film(), seconds, named(QualityName::Draft)));
        for (int gap : {4, 6})
            for (int before = 1; before < gap; ++before) {
                double between = decibels(film(), truth, made(film(), seconds, gap, before));
                EXPECT_GT(between, std::fmin(draft - 3, 36)) << seconds << ' ' << before << '/' << gap;
            }
    }
}

// The nearer an in-between is to one of the pictures, the more similar they are.
TEST(Between, GoesFromOneToTheOther) {
    Intro &intro = film();
    const Bytes first = bytesOf(picture(intro, 0, 30, named(QualityName::Play))),
                last = bytesOf(picture(intro, 1, 30 + 4 * kStep, named(QualityName::Play)));
    auto differs = [](const Bytes &a, const Picture &b) {
        double sum = 0;
        for (size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b.rgba[i]);
        return sum;
    };
    double fromFirst = 0, fromLast = 1e9;
    for (double share : {0.25, 0.5, 0.75}) {
        Picture p = between(intro, 0, 1, share, (int)(share * 4));
        EXPECT_GT(differs(first, p), fromFirst) << share;
        EXPECT_LT(differs(last, p), fromLast) << share;
        fromFirst = differs(first, p), fromLast = differs(last, p);
    }
}

// A player keeps several in-betweens, each in its buffer.
TEST(Between, StaysInItsBuffer) {
    Intro &intro = film();
    picture(intro, 0, 30, named(QualityName::Draft));
    picture(intro, 1, 30 + 6 * kStep, named(QualityName::Draft));
    std::vector<Bytes> first;
    std::vector<Picture> pictures;
    for (int k = 0; k < kBetweenBuffers; ++k) {
        pictures.push_back(between(intro, 0, 1, (k + 1) / 6., k));
        first.push_back(bytesOf(pictures.back()));
    }
    for (size_t k = 0; k < kBetweenBuffers; ++k) EXPECT_TRUE(first[k] == bytesOf(pictures[k])) << k;
}

// Next to a cut an in-between shows its own shot, and is made only from the picture of that shot.
TEST(Between, ShowsItsOwnShotNextToACut) {
    Intro &intro = film();
    int i = 1;
    while (kFilm.shots[i].scene == kFilm.shots[0].scene) ++i;
    double cut = kFilm.shots[i].row / kRowsPerSecond;
    picture(intro, 0, cut - 2.5 * kStep, named(QualityName::Play));
    picture(intro, 1, cut + 1.5 * kStep, named(QualityName::Play));
    for (double share : {0.25, 0.5, 0.75}) {
        if (kSanitized && share != 0.5) continue;
        double seconds = cut + (share * 4 - 2.5) * kStep;
        Bytes shown = bytesOf(between(intro, 0, 1, share));
        LoadedFilm other(1, kWidth, kHeight, true);
        Bytes traced = bytesOf(picture(*other.intro, 0, seconds, named(QualityName::Play)));
        EXPECT_GT(pictures::psnr(shown, traced), 28) << share;
    }
}

// Slots belong to the caller: either slot may hold the earlier picture, and making an in-between changes
// neither.
TEST(Between, UsesTheSlotsThatAreNamed) {
    Intro &intro = film();
    auto trace = [&](int slot, double seconds) { picture(intro, slot, seconds, named(QualityName::Play)); };
    trace(0, 30 - kStep);
    trace(1, 30 + kStep);
    Bytes first = bytesOf(between(intro, 0, 1));
    EXPECT_EQ(bytesOf(between(intro, 0, 1)), first);
    trace(0, 30 + 3 * kStep);
    EXPECT_NE(bytesOf(between(intro, 1, 0)), first) << "a later moment";
    trace(1, 30 - kStep);
    trace(0, 30 + kStep);
    EXPECT_EQ(bytesOf(between(intro, 1, 0)), first);
}

// The result does not depend on the number of threads, at moments of the whole film and for all gaps.
TEST(Between, IsTheSameForAllThreads) {
    bool hall = !kSanitized;
    const Gl *gl = hall ? &headlessGl() : nullptr;
    LoadedFilm one(1, kWidth, kHeight, true, gl), five(5, kWidth, kHeight, true, gl);
    for (double seconds = 2; seconds < (hall ? 160 : 40); seconds += 20) {
        int gap = 2 + (int)(seconds / 20) % 3 * 2;
        EXPECT_EQ(made(*one.intro, seconds, gap, 1), made(*five.intro, seconds, gap, 1))
            << seconds << ' ' << gap;
    }
}
