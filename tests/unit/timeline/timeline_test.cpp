#include "timeline/camera.h"
#include "timeline/shot.h"
#include "timeline/track.h"

using namespace odraz;
using enum Interpolation;

// --- Tracks ---

TEST(Track, EmptyIsZero) { EXPECT_EQ(value(Track{nullptr, 0}, 5), 0); }

TEST(Track, HoldsBeforeTheFirstAndAfterTheLastKey) {
    static constexpr Key keys[] = {{4, 2, Linear}, {8, 6, Linear}};
    EXPECT_EQ(value(track(keys), -1e9), 2);
    EXPECT_EQ(value(track(keys), 3.999), 2);
    EXPECT_EQ(value(track(keys), 8.001), 6);
    EXPECT_EQ(value(track(keys), 1e9), 6);
    static constexpr Key one[] = {{4, 2, Smooth}};
    for (double row : {-5., 4., 40.}) EXPECT_EQ(value(track(one), row), 2);
}

TEST(Track, MeetsEveryKeyAndInterpolatesAsRocketDoes) {
    struct {
        Interpolation kind;
        float quarter, half;
    } const expected[] = {{Linear, 0.25f, 0.5f}, {Smooth, 0.15625f, 0.5f}};
    for (auto e : expected) {
        const Key keys[] = {{10, 0, e.kind}, {14, 1, e.kind}, {20, -3, e.kind}};
        Track t = {keys, 3};
        EXPECT_EQ(value(t, 10), 0);
        EXPECT_EQ(value(t, 14), 1);
        EXPECT_EQ(value(t, 20), -3);
        EXPECT_FLOAT_EQ(value(t, 11), e.quarter);
        EXPECT_FLOAT_EQ(value(t, 12), e.half);
        EXPECT_FLOAT_EQ(value(t, 17), 1 - 4 * e.half);
    }
}

TEST(Track, UsesTheLaterOfTwoKeysOnOneRow) {
    static constexpr Key keys[] = {{0, 1, Linear}, {4, 2, Linear}, {4, 7, Linear}, {8, 8, Linear}};
    EXPECT_EQ(value(track(keys), 4), 7);
    EXPECT_NEAR(value(track(keys), 3.9999), 2, 1e-3);
    EXPECT_FLOAT_EQ(value(track(keys), 6), 7.5f);
}

// --- Camera ---

static constexpr CameraKey kKeys[] = {
    {0, {0, 1, 5}, {0, 0, 0}, 0, 40},       {8, {3, 1, 4}, {0.5f, 0, 0}, 5, 42},
    {11, {4, 2, 0}, {1, 0, 0}, -4, 40},     {40, {-2, 3, -6}, {0, 1, 0}, 0, 30},
    {41, {-2.2f, 3, -6}, {0, 1, 0}, 0, 30},
};

TEST(Camera, MeetsItsKeysAndHoldsOutside) {
    for (const CameraKey &k : kKeys) {
        CameraKey p = pose(path(kKeys), k.row);
        EXPECT_EQ(p.eye.x, k.eye.x);
        EXPECT_EQ(p.target.y, k.target.y);
        EXPECT_EQ(p.roll, k.roll);
        EXPECT_EQ(p.fov, k.fov);
    }
    EXPECT_EQ(pose(path(kKeys), -100).eye.z, 5);
    EXPECT_EQ(pose(path(kKeys), 1e7).eye.x, -2.2f);
}

TEST(Camera, IsContinuousInPositionAndVelocity) {
    double h = 1e-3, before = 0, steepest = 0;
    for (double row = 0; row < 41 - h; row += h) {
        double v = ((double)pose(path(kKeys), row + h).eye.x - (double)pose(path(kKeys), row).eye.x) / h;
        if (row > 0) steepest = std::fmax(steepest, std::fabs(v - before));
        before = v;
    }
    EXPECT_LT(steepest, 0.02); // a jump would be as large as the velocities, about 1 a row
}

TEST(Camera, BeginsAndEndsInMotionAndRestsWhereKeysAreEqual) {
    auto speed = [](CameraPath path, double row) {
        return ((double)pose(path, row + 0.01).eye.x - (double)pose(path, row).eye.x) / 0.01;
    };
    EXPECT_GT(speed(path(kKeys), 0), 0.3);
    EXPECT_LT(speed(path(kKeys), 40.985), -0.1);
    EXPECT_GT(speed(path(kKeys), 8), 0.2);
    static constexpr CameraKey even[] = {{0, {0, 0, 0}, {0, 0, -1}, 0, 40},
                                         {8, {4, 0, 0}, {0, 0, -1}, 0, 40}};
    for (double row : {0., 3., 7.98}) EXPECT_NEAR(speed(path(even), row), 0.5, 1e-3);
    static constexpr CameraKey eased[] = {{0, {0, 0, 0}, {0, 0, -1}, 0, 40},
                                          {2, {0, 0, 0}, {0, 0, -1}, 0, 40},
                                          {8, {4, 0, 0}, {0, 0, -1}, 0, 40}};
    EXPECT_NEAR(speed(path(eased), 0), 0, 1e-3);
    EXPECT_GT(speed(path(eased), 5), 0.3);
}

TEST(Camera, DegeneratePathsGiveAPose) {
    EXPECT_EQ(pose(CameraPath{nullptr, 0}, 3).target.z, -1);
    static constexpr CameraKey twice[] = {{0, {0, 0, 0}, {0, 0, -1}, 0, 40},
                                          {4, {1, 0, 0}, {0, 0, -1}, 0, 40},
                                          {4, {2, 0, 0}, {0, 0, -1}, 0, 40},
                                          {8, {3, 0, 0}, {0, 0, -1}, 0, 40}};
    for (double row = -1; row < 10; row += 0.25)
        EXPECT_TRUE(std::isfinite(pose(path(twice), row).eye.x)) << row;
}

// --- Shots ---

TEST(Shots, CutHardAndFadeAtTheirEdges) {
    static constexpr Shot shots[] = {
        {0, 7, 0, {nullptr, 0}, 4, 2}, {16, 8, 16, {nullptr, 0}, 0, 8}, {48, 8, 16, {nullptr, 0}, 0, 0}};
    ShotList list = {shots, 3, 64};
    EXPECT_EQ(momentAt(list, 15.999).shot->scene, 7);
    EXPECT_EQ(momentAt(list, 16).shot->scene, 8);
    EXPECT_EQ(momentAt(list, 16).fade, 1);
    EXPECT_EQ(momentAt(list, 0).fade, 0);
    EXPECT_FLOAT_EQ(momentAt(list, 1).fade, 0.25f);
    EXPECT_FLOAT_EQ(momentAt(list, 15).fade, 0.5f);
    EXPECT_FLOAT_EQ(momentAt(list, 44).fade, 0.5f);
    EXPECT_EQ(momentAt(list, 50).storyRow, 34); // the story continues across the cut
}

TEST(Shots, ClampOutsideTheFilm) {
    static constexpr Shot shots[] = {{0, 1, 0, {nullptr, 0}, 0, 0}};
    ShotList list = {shots, 1, 32};
    EXPECT_EQ(momentAt(list, -5).storyRow, 0);
    EXPECT_EQ(momentAt(list, 1e9).storyRow, 32);
}
