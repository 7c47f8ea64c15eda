// Tests the rules for any film made with this engine: cuts are on beats, cameras have keys for their whole
// shots and neither jump nor run into shapes, events are within their scenes, and no picture has a NaN.
#include "inside.h"
#include "show/events.h"
#include "tests/support/loaded_film.h"
#include "tests/support/pictures.h"
#include "tests/support/sanitized.h"
#include "tests/support/shapes.h"
#include "tests/support/shots.h"

using namespace odraz;

// Limits that a viewer can follow: the eye moves no faster than a runner or, far away, by no more than a
// share of the distance to its target in a second. It turns no faster than a head.
constexpr double kFastest = 6, kFastestTurn = 60, kFastestShare = 0.12; // metres, degrees a second
constexpr double kRowsPerBeat = kRowsPerBar / 4, kShortestShot = kRowsPerBeat;
constexpr int kDarkSeconds = 3; // the film opens on black, and fades may pass through black

TEST(Rules, CutsAreOnBeats) {
    EXPECT_EQ(kFilm.shots[0].row, 0);
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &s = kFilm.shots[i];
        EXPECT_EQ(std::fmod(s.row, kRowsPerBeat), 0) << "shot " << i;
        EXPECT_GE(endOf(i) - s.row, kShortestShot) << "shot " << i;
        EXPECT_LE(s.fadeIn + s.fadeOut, endOf(i) - s.row) << "shot " << i << " is shorter than its fades";
    }
}

TEST(Rules, EveryPathSpansItsShot) {
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &s = kFilm.shots[i];
        ASSERT_GT(s.path.count, 0) << "shot " << i << " has no camera";
        if (s.path.count == 1) continue; // a still camera
        EXPECT_LE(s.path.keys[0].row, s.row - s.storyRow) << "shot " << i << " begins before its first key";
        EXPECT_GE(s.path.keys[s.path.count - 1].row, endOf(i) - s.storyRow)
            << "shot " << i << " ends after its last key";
        for (int k = 1; k < s.path.count; ++k)
            EXPECT_GT(s.path.keys[k].row, s.path.keys[k - 1].row) << "shot " << i << ", key " << k;
    }
}

TEST(Rules, CamerasDoNotJump) {
    for (int i = 0; i < kFilm.count; ++i) {
        double start = kFilm.shots[i].row / kRowsPerSecond, end = endOf(i) / kRowsPerSecond;
        constexpr double kStep = 0.05; // seconds
        for (double t = start + kStep; t + kStep < end; t += kStep) {
            // Stay after the cut, however t is rounded
            CameraKey a = cameraAt(std::fmax(t - kStep, start)), b = cameraAt(t);
            EXPECT_LT(length(b.eye - a.eye) / kStep,
                      std::fmax(kFastest, kFastestShare * (double)length(b.target - b.eye)))
                << "at " << t << " s";
            EXPECT_LT(degreesBetween(a, b) / kStep, kFastestTurn) << "at " << t << " s";
        }
    }
}

// Events are after the start of their scene and before its end. (Shots of other scenes may be in between.)
TEST(Rules, EventsAreWithinTheirScene) {
    for (const Event &e : kEvents) {
        float begins = (float)firstRow(e.scene), ends = begins;
        for (int i = 0; i < kFilm.count; ++i)
            if (kFilm.shots[i].scene == e.scene && kFilm.shots[i].storyRow == begins) ends = endOf(i);
        EXPECT_TRUE(e.row >= 0 && begins + e.row < ends)
            << "event " << (int)e.id << ", row " << e.row << " of " << kScenes[e.scene].name;
    }
}

TEST(Rules, CamerasAreNeverInsideShapes) {
    const Scene *scene = smallFilm().film.scene;
    for (double t = 0; t < duration(); t += kSanitized ? 0.5 : 0.1) {
        Posed now = poseAt(smallFilm().film, t);
        Vec3 eye = now.input.camera.eye;
        for (int i = 0; i < scene->shapeCount; ++i)
            EXPECT_GE(distanceFrom(scene->shapes[i], eye), 0.1f)
                << "at " << t << " s in shape " << i << " of " << now.scene().name;
    }
}

TEST(Rules, NoPictureHasANaN) {
    int dark = 0;
    for (double t = 0; t < duration(); t += kSanitized ? 5 : 1) {
        picture(smallFilm(), 0, t, kQualities[(int)QualityName::Play]);
        EXPECT_STREQ(exceededLimit(smallFilm()), nullptr) << t;
        double sum = 0;
        for (float v : planesOf(smallFilm().frame)) {
            ASSERT_TRUE(v >= 0) << t;
            sum += v;
        }
        dark += sum < 1;
    }
    EXPECT_LE(dark, kDarkSeconds);
}

TEST(Rules, APictureDependsOnlyOnItsTime) {
    auto bytes = [](double t) { return bytesOf(picture(smallFilm(), 0, t, named(QualityName::Film))); };
    double end = duration();
    auto first = bytes(0.19 * end);
    bytes(0.62 * end);
    bytes(0);
    EXPECT_EQ(bytes(0.19 * end), first);
}
