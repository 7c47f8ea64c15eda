#include "inside.h"
#include "show/font.h"
#include "tests/support/loaded_film.h"
#include "tests/support/pictures.h"
#include "trace/picture/development.h"
#include "trace/picture/overlay.h"

using namespace odraz;

struct Canvas {
    HeapArena memory;
    Frame frame;
    Canvas(int width, int height) : memory((size_t)(width + 8) * (size_t)height * 16 + 1024) {
        EXPECT_TRUE(makeFrame(frame, memory.arena, width, height));
    }
    float &at(int x, int y) { return frame.plane[0][y * frame.stride + x]; }
    double sum() const {
        std::vector<float> red = planeOf(frame, 0);
        return std::accumulate(red.begin(), red.end(), 0.);
    }
    void fill(float radiance) {
        for (float *plane : frame.plane)
            std::fill_n(plane, (size_t)frame.stride * (size_t)frame.height, radiance);
    }
    void develop(float exposure = 1, uint32_t seed = 0) {
        static const ToneCurve curve = [] {
            ToneCurve made;
            makeToneCurve(made);
            return made;
        }();
        Workers workers = serialWorkers();
        odraz::develop(curve, frame, workers, exposure, seed);
    }
};

TEST(ToneMapping, RisesFromBlackToWhiteWithoutClipping) {
    float before = -1;
    for (float x = 0; x < 50; x = x * 1.05f + 0.001f) {
        float y = filmic(broadcast(x))[0];
        EXPECT_GT(y, before);
        EXPECT_LT(y, 1);
        before = y;
    }
    EXPECT_EQ(filmic(broadcast(0.f))[0], 0);
    EXPECT_NEAR(filmic(broadcast(0.18f))[0], 0.26, 0.01);
    EXPECT_NEAR(filmic(broadcast(1.f))[0], 0.78, 0.01);
    EXPECT_LE(filmic(broadcast(kInfinity))[0], 1);
    EXPECT_EQ(filmic(broadcast(NAN))[0], 0);
}

TEST(Srgb, FollowsTheStandard) {
    for (int i = 0; i <= 1000; ++i) {
        double x = i / 1000., y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
        EXPECT_NEAR(encodeSrgb(broadcast((float)x))[0], y, 1e-6);
    }
}

// The developed values of some radiances, each of which fills one row of pixels.
struct Developed {
    static constexpr int kWidth = 512;
    Canvas canvas;

    explicit Developed(const std::vector<float> &radiances, float exposure = 1, uint32_t seed = 0)
        : canvas(kWidth, (int)radiances.size()) {
        for (float *plane : canvas.frame.plane)
            for (size_t y = 0; y < radiances.size(); ++y)
                std::fill_n(plane + y * kWidth, (size_t)kWidth, radiances[y]);
        canvas.develop(exposure, seed);
    }
    int at(int x, int y, int c) const { return canvas.frame.rgba[(y * kWidth + x) * 4 + c]; }
    double mean(int y, int c = 0) const {
        double sum = 0;
        for (int x = 0; x < kWidth; ++x) sum += at(x, y, c);
        return sum / kWidth;
    }
};

// Returns the exact value, computed from the definition.
static double exact(float radiance) { return 255 * (double)encodeSrgb(filmic(broadcast(radiance)))[0]; }

// The noise of a flat picture: the shown values minus their mean, for `seed` and colour `c`.
static std::vector<double> noiseOf(uint32_t seed, int c) {
    Developed d(std::vector<float>(256, 0.2f), 1, seed);
    std::vector<double> noise;
    double mean = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < Developed::kWidth; ++x) noise.push_back(d.at(x, y, c)), mean += noise.back();
    for (double &v : noise) v -= mean / (double)noise.size();
    return noise;
}

static double correlation(const std::vector<double> &a, const std::vector<double> &b) {
    double ab = 0, aa = 0, bb = 0;
    for (size_t i = 0; i < a.size(); ++i) ab += a[i] * b[i], aa += a[i] * a[i], bb += b[i] * b[i];
    return ab / std::sqrt(aa * bb);
}

// A pixel that is brighter than all its neighbours gets the value of the brightest neighbour; lines, corners
// and pairs stay. The test tries every pixel of a picture of odd size, including the edges, where there are
// fewer neighbours.
TEST(Develop, ShowsNoSparks) {
    constexpr int kWidth = 21, kHeight = 9;
    for (int at = 0; at < kWidth * kHeight; ++at) {
        int x = at % kWidth, y = at / kWidth;
        for (bool pair : {false, true}) {
            Canvas c(kWidth, kHeight);
            c.fill(0.2f);
            for (float *plane : c.frame.plane) {
                plane[y * c.frame.stride + x] = 5;
                if (pair) plane[(y ? y - 1 : 1) * c.frame.stride + x] = 5; // above it, or below
            }
            c.develop();
            EXPECT_NEAR(c.frame.rgba[4 * at], exact(pair ? 5 : 0.2f), 1.1) << x << ',' << y;
            EXPECT_EQ(c.frame.rgba[4 * at + 3], 255);
            EXPECT_NEAR(c.frame.rgba[4 * ((at + 3) % (kWidth * kHeight))], exact(0.2f), 1.1);
        }
    }
}

// With noise, the mean of many pixels has more than eight bits: it gives the table's value without steps. The
// mean of 512 pixels is within 1/40 of a step.
TEST(Develop, TheTableIsTheCurveAndNoiseShowsWhatLiesBetweenSteps) {
    std::vector<float> radiances;
    for (float x = 1e-6f; x < 1e5f; x *= 1.013f) radiances.push_back(x);
    for (float exposure : {1.f, 0.37f}) {
        Developed d(radiances, exposure);
        double squares = 0;
        for (size_t i = 0; i < radiances.size(); ++i) {
            double off = d.mean((int)i) - exact(radiances[i] * exposure);
            squares += off * off;
            EXPECT_LT(std::fabs(off), 0.1) << radiances[i];
            for (int x = 0; x < Developed::kWidth; ++x)
                EXPECT_NEAR(d.at(x, (int)i, 1), exact(radiances[i] * exposure), 1.03) << radiances[i];
        }
        EXPECT_LT(std::sqrt(squares / (double)radiances.size()), 0.025);
    }
}

// The table itself, without noise, at floats of all sizes. development.h states the bound.
TEST(Develop, TheTableIsWithinAFortiethOfAStep) {
    ToneCurve curve;
    makeToneCurve(curve);
    double worst = 0;
    for (uint32_t b = 0; b < 0x7f800000; b += 997) {
        float radiance = fromBits((int32_t)b);
        float v = clamp(radiance + ToneCurve::kFoot, ToneCurve::kFoot, ToneCurve::kHead);
        int at = bits(v) - bits(ToneCurve::kFoot), entry = curve.entry[at >> ToneCurve::kShift];
        double share = (at & ((1 << ToneCurve::kShift) - 1)) / (double)(1 << ToneCurve::kShift);
        double shown = ((entry >> 16) + (int16_t)entry * share) / 128;
        worst = std::max(worst, std::fabs(shown - exact(radiance)));
    }
    EXPECT_LT(worst, 0.025);
}

TEST(Develop, ExtremesAreBlackOrWhite) {
    Developed d({0.f, -0.f, 1e-45f, 1e-39f, -1.f, -kInfinity, NAN, -NAN, 1e30f, 3e38f, kInfinity});
    for (int c = 0; c < 3; ++c) {
        for (int y = 0; y < 8; ++y) EXPECT_EQ(d.mean(y, c), 0) << y;
        for (int y = 8; y < 11; ++y) EXPECT_EQ(d.mean(y, c), 255) << y;
    }
    EXPECT_EQ(Developed({kInfinity}, 0).mean(0), 0); // the dark end of a fade
}

TEST(Develop, ColoursAndSeedsHaveIndependentNoise) {
    std::vector<double> red = noiseOf(0, 0), green = noiseOf(0, 1), blue = noiseOf(0, 2);
    std::vector<double> correlations = {correlation(red, green), correlation(green, blue),
                                        correlation(blue, red)};
    for (uint32_t seed : {1u, 4u, 10u, 1000u}) correlations.push_back(correlation(red, noiseOf(seed, 0)));
    for (double c : correlations) EXPECT_LT(std::fabs(c), 0.01); // 131,072 pixels: 0.0028 is usual
    EXPECT_EQ(red, noiseOf(0, 0));
}

// The noise moves even where the film hardly does; the same time has the same noise.
TEST(Develop, NoiseMovesWithTheFilm) {
    LoadedFilm film(1, 320, 180, false);
    auto shown = [&](double time, std::vector<float> &red) {
        Picture p = picture(*film.intro, 0, time, named(QualityName::Draft));
        red = planeOf(film.intro->frame, 0);
        return bytesOf(p);
    };
    std::vector<float> red, next;
    std::vector<uint8_t> first = shown(33.2, red), again = shown(33.2, red),
                         then = shown(33.2 + 1 / 60., next);
    EXPECT_EQ(first, again);
    float exposure = film.intro->film.scene->exposure;
    int still = 0, moved = 0;
    for (size_t i = 0; i < red.size(); ++i) {
        double light = exact(red[i] * exposure); // 0 .. 255
        if (light < 1 || light > 254 || std::fabs(exact(next[i] * exposure) - light) > 0.02) continue;
        ++still;
        moved += first[4 * i] != then[4 * i];
    }
    EXPECT_GT(still, 3000);
    EXPECT_GT(moved, still / 4); // without noise: one in a hundred
}

TEST(Strokes, CoverTheirArea) {
    Canvas c(100, 40);
    Stroke s = {20.3f, 20.7f, 80.1f, 20.7f};
    drawStrokes(c.frame, &s, 1, 3, {1, 1, 1}, 1);
    EXPECT_NEAR(c.sum(), 59.8 * 6 + M_PI * 9, 2);
    EXPECT_EQ(c.at(50, 20), 1);
    EXPECT_EQ(c.at(50, 30), 0);
}

TEST(Strokes, DoNotAddUpWhereTheyOverlap) {
    Canvas c(64, 64);
    Stroke s[2] = {{10, 10, 50, 50}, {10, 10, 50, 50}};
    drawStrokes(c.frame, s, 2, 2, {1, 1, 1}, 0.5f);
    EXPECT_FLOAT_EQ(c.at(30, 30), 0.5f);
}

TEST(Strokes, MayLieOutsideThePicture) {
    Canvas c(32, 32);
    Stroke s[3] = {{-1e6f, -1e6f, 1e6f, 1e6f}, {-50, -50, -40, -40}, {1e9f, 0, 1e9f, 1e9f}};
    drawStrokes(c.frame, s, 1, 1, {1, 1, 1}, 1);
    EXPECT_GT(c.at(16, 16), 0.3f);
    double before = c.sum();
    drawStrokes(c.frame, s + 1, 2, 1, {1, 1, 1}, 1);
    EXPECT_EQ(c.sum(), before);
}

TEST(Font, DrawsItsCharactersAndLeavesOutOthers) {
    for (const char *p = "abcdefghijklmnopqrstuvwxyz0123456789.,:-+/"; *p; ++p) {
        Canvas c(64, 64);
        char text[2] = {*p, 0};
        drawText(c.frame, text, 20, 44, {30, 0.1f, Align::Left, {1, 1, 1}, 1, 0});
        EXPECT_GT(c.sum(), 5) << *p;
    }
    Canvas c(64, 64);
    drawText(c.frame, " \x7f\xff{", 20, 44, {30, 0.1f, Align::Left, {1, 1, 1}, 1, 0});
    EXPECT_EQ(c.sum(), 0);
}

TEST(Font, AlignsAndIgnoresCase) {
    auto middle = [](const char *text, Align align) {
        Canvas c(200, 40);
        drawText(c.frame, text, 100, 30, {16, 0.1f, align, {1, 1, 1}, 1, 0});
        double sum = 0, moment = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 200; ++x) sum += c.at(x, y), moment += c.at(x, y) * x;
        return moment / sum;
    };
    EXPECT_NEAR(middle("odraz", Align::Centre), 100, 4);
    EXPECT_GT(middle("odraz", Align::Left), 115);
    EXPECT_LT(middle("odraz", Align::Right), 85);
    EXPECT_EQ(middle("ODRAZ", Align::Left), middle("odraz", Align::Left));
}
