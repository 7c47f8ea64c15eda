#include "show/font.h"
#include "tools/common/heap_arena.h"
#include "trace/picture/development.h"
#include "trace/picture/overlay.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

using namespace odraz;

namespace {

struct Canvas {
    HeapArena memory;
    Frame frame;
    Canvas(int width, int height) : memory((size_t)(width + 8) * (size_t)height * 16 + 1024) {
        EXPECT_TRUE(makeFrame(frame, memory.arena, width, height));
    }
    float &at(int x, int y) { return frame.plane[0][y * frame.stride + x]; }
    double sum() {
        double s = 0;
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) s += at(x, y);
        return s;
    }
};

} // namespace

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

TEST(Develop, WritesEveryPixelOfOddSizesAndDithersByHalfABit) {
    Canvas c(13, 5);
    for (float *plane : c.frame.plane) std::fill_n(plane, (size_t)c.frame.stride * 5, 0.2f);
    Workers workers = serialWorkers();
    develop(c.frame, workers, 1);
    double mean = 0, exact = 255 * (double)encodeSrgb(filmic(broadcast(0.2f)))[0];
    for (int i = 0; i < 13 * 5; ++i) {
        EXPECT_EQ(c.frame.rgba[4 * i + 3], 255);
        EXPECT_NEAR(c.frame.rgba[4 * i], exact, 1.01);
        mean += c.frame.rgba[4 * i] / 65.;
    }
    EXPECT_NEAR(mean, exact, 0.3);
}

TEST(Develop, BlackIsBlack) {
    Canvas c(16, 16);
    Workers workers = serialWorkers();
    develop(c.frame, workers, 1);
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(c.frame.rgba[4 * i] + c.frame.rgba[4 * i + 1] + c.frame.rgba[4 * i + 2], 0);
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

TEST(Font, KnowsItsCharactersAndLeavesOutOthers) {
    for (const char *p = "abcdefghijklmnopqrstuvwxyz0123456789.,:-+/"; *p; ++p) {
        Canvas c(64, 64);
        char text[2] = {*p, 0};
        drawText(c.frame, text, 20, 44, 30, 0.1f, 0, Align::Left, {1, 1, 1}, 1);
        EXPECT_GT(c.sum(), 5) << *p;
    }
    Canvas c(64, 64);
    drawText(c.frame, " \x7f\xff{", 20, 44, 30, 0.1f, 0, Align::Left, {1, 1, 1}, 1);
    EXPECT_EQ(c.sum(), 0);
}

TEST(Font, AlignsAndIgnoresCase) {
    auto middle = [](const char *text, Align align) {
        Canvas c(200, 40);
        drawText(c.frame, text, 100, 30, 16, 0.1f, 0, align, {1, 1, 1}, 1);
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
