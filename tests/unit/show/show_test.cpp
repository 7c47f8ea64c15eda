// Checks this film's treatment: its cuts, camera motion, levels and balls. rules_test.cpp has the rules for
// any film.
#include "inside.h"
#include "tests/support/loaded_film.h"
#include "tests/support/sanitized.h"
#include "tests/support/shapes.h"
#include "tests/support/shots.h"
#include "tools/common/statistics.h"

using namespace odraz;

// The treatment demands this number of cuts, and these lenses: focal lengths in mm for a picture 24 mm high.
constexpr int kLeastCuts = 35;
// Stretches in which the point of light is all that is seen, in seconds.
constexpr struct { double from, to; } kBlack[] = {{56, 57.6}, {98, 98.75}, {111.5, 112}, {140.25, 141}};
constexpr double kLenses[] = {18, 24, 35, 50, 100};

TEST(Film, HasTheCutsAndTheLengthOfItsTreatment) {
    EXPECT_GE(kFilm.count - 1, kLeastCuts);
    EXPECT_NEAR(duration(), 160, 5);
}

TEST(Film, HasTheLensesOfItsTreatment) {
    for (double lens : kLenses) {
        int used = 0;
        for (int i = 0; i < kFilm.count; ++i) {
            const Shot &s = kFilm.shots[i];
            double mm = 12 / std::tan((double)pose(s.path, s.row - s.storyRow).fov * 3.14159265 / 360);
            used += std::fabs(mm / lens - 1) < 0.12;
        }
        EXPECT_GT(used, 0) << lens << " mm";
    }
}

// In each second the camera's target moves through the picture by at least an eightieth of the picture's
// height. (Far away, through a long lens, a walking camera may look still.)
TEST(Film, NoCameraIsStill) {
    for (int i = 0; i < kFilm.count; ++i) {
        if (kFilm.shots[i].path.count == 1) continue; // a camera on its tripod: what it looks at moves
        double end = endOf(i) / kRowsPerSecond;
        for (double t = kFilm.shots[i].row / kRowsPerSecond; t + 1 < end; t += 0.25) {
            CameraKey a = cameraAt(t), b = cameraAt(t + 1);
            double passes = (double)(length(b.eye - a.eye) / length(a.target - a.eye)) * 57.3,
                   zooms = std::fabs((double)(b.fov - a.fov));
            EXPECT_GT((passes + degreesBetween(a, b) + zooms) / (double)a.fov, 0.0125) << t;
        }
    }
}

TEST(Film, EveryEventIsOnABeat) {
    for (const Event &e : kEvents) EXPECT_EQ(e.row % 4, 0) << kScenes[e.scene].name << ' ' << e.row;
}

// Paths have no kinks, and no shot begins or ends at rest. In each bar, a camera's speed stays within a
// quarter of its mean, except while it eases in or out.
TEST(Film, CamerasMoveEvenly) {
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &shot = kFilm.shots[i];
        if (shot.path.count == 1) continue;
        double end = endOf(i);
        auto velocity = [&](double row) {
            constexpr double h = 0.02; // rows
            CameraKey a = pose(shot.path, row - shot.storyRow - h / 2),
                      b = pose(shot.path, row - shot.storyRow + h / 2);
            return (b.eye - a.eye) * (float)(kRowsPerSecond / h);
        };
        double fastest = 0, rough = 0;
        for (double row = shot.row + 0.1; row < end - 0.25; row += 0.1) {
            Vec3 v = velocity(row), jump = velocity(row + 0.1) - v;
            fastest = std::fmax(fastest, length(v)), rough = std::fmax(rough, length(jump));
        }
        EXPECT_LT(rough, 0.08 * fastest + 0.01) << "shot " << i; // per tenth of a row
        EXPECT_GT(length(velocity(shot.row + 0.1)), 0.02 * fastest) << "shot " << i << " begins at rest";
        EXPECT_GT(length(velocity(end - 0.1)), 0.02 * fastest) << "shot " << i << " ends at rest";
        for (double bar = shot.row; bar + kRowsPerBar <= end; bar += kRowsPerBar) {
            double sum = 0, least = 1e9, most = 0, first = 0, last = 0;
            int count = 0;
            for (double row = bar + 0.2; row < bar + kRowsPerBar - 0.1; row += 0.2, ++count) {
                double speed = length(velocity(row));
                sum += speed, least = std::fmin(least, speed), most = std::fmax(most, speed);
                if (!count) first = speed;
                last = speed;
            }
            double mean = sum / count;
            bool eases = std::fabs(last - first) > 0.6 * (most - least); // over the whole bar
            if (eases || mean < 0.05) continue;
            EXPECT_LT(most, 1.25 * mean) << "shot " << i << ", bar " << bar / kRowsPerBar;
            EXPECT_GT(least, 0.75 * mean) << "shot " << i << ", bar " << bar / kRowsPerBar;
        }
    }
}

// Levels fit the treatment: no picture is too dark or too bright, hardly any pixel is clipped, and colours
// are moderate.
FIGURES_TEST(Film, LevelsFitTheTreatment) {
    for (int scene = 0; scene < kSceneCount; ++scene) {
        double least = 255, most = 0, clipped = 0;
        std::vector<float> medians;
        for (double t = 0.5; t < duration(); t += 1) {
            if (std::any_of(std::begin(kBlack), std::end(kBlack),
                            [=](auto &black) { return t >= black.from && t < black.to; }))
                continue;
            Moment now = momentAt(kFilm, t * kRowsPerSecond);
            if (now.shot->scene != scene || now.fade < 1) continue;
            Picture p = picture(smallFilm(), 0, t, kQualities[(int)QualityName::Draft]);
            double level = 0;
            int white = 0;
            std::vector<float> saturations;
            for (int i = 0; i < p.width * p.height; ++i) {
                const uint8_t *c = p.rgba + 4 * i;
                int high = std::max({c[0], c[1], c[2]}), low = std::min({c[0], c[1], c[2]});
                level += (c[0] + c[1] + c[2]) / 3.;
                white += low >= 254;
                if (high > 12) saturations.push_back((float)(high - low) / (float)high);
            }
            level /= p.width * p.height;
            least = std::fmin(least, level), most = std::fmax(most, level);
            clipped = std::fmax(clipped, 100. * white / (p.width * p.height));
            if (saturations.size() > 1000) medians.push_back(common::median(saturations));
        }
        ASSERT_FALSE(medians.empty());
        double saturation = common::median(medians);
        SCOPED_TRACE(kScenes[scene].name);
        bool black = scene == kPoint || scene == kCredits; // the scene is mostly black
        EXPECT_GE(least, black ? 1 : 7);
        EXPECT_LE(most, 130);
        EXPECT_LT(clipped, scene == kOdraz ? 1 : 0.5); // the point of light passes close to the lens
        EXPECT_TRUE(black || (saturation >= 0.12 && saturation <= 0.6)) << saturation;
    }
}

TEST(Film, BallsDoNotRollThroughShapes) {
    const Scene *scene = smallFilm().film.scene;
    for (double t = 0; t < duration(); t += kSanitized ? 1 : 0.25) {
        Posed now = poseAt(smallFilm().film, t);
        for (int i = 0; i < scene->shapeCount; ++i)
            for (int j = 0; j < i; ++j) {
                const Shape &a = scene->shapes[i], &b = scene->shapes[j];
                if (!a.isBall() || b.kind == ShapeKind::Plane) continue;
                // At the door the balls pass through the wall
                if (now.scene().id == kOdraz && b.kind == ShapeKind::Rect && b.centre.z < -8.99f) continue;
                // The point of light writes the word
                if (now.scene().id == kPoint && b.kind == ShapeKind::Cylinder) continue;
                EXPECT_GT(distanceFrom(b, a.centre) - a.half.x, -1e-3f)
                    << "at " << t << " s: shapes " << i << " and " << j << " of " << now.scene().name;
            }
    }
}

// Detail, gloss and the light at the camera depend on the camera in use, scripted or flown.
TEST(Film, IsPosedForTheCameraInUse) {
    constexpr double kInHall = 85, kAtFlake = 45; // seconds
    const Film &f = smallFilm().film;
    auto gloss = [&] {
        const Glossy &g = f.hall->gloss;
        return std::vector<float>(g.plane[1], g.plane[1] + g.across * g.down);
    };
    CameraKey moved = cameraAt(kInHall);
    moved.eye += Vec3{1, 0.5f, 0};
    poseAt(f, kInHall);
    auto scripted = gloss();
    Posed flown = poseAt(f, kInHall, &moved);
    EXPECT_NE(gloss(), scripted);
    EXPECT_EQ(flown.input.camera.eye.x, moved.eye.x);
    EXPECT_EQ(flown.view(16, 9).eye.x, moved.eye.x);
    poseAt(f, kInHall);
    EXPECT_EQ(gloss(), scripted);

    CameraKey far = cameraAt(kAtFlake);
    poseAt(f, kAtFlake);
    int shapes = f.scene->shapeCount;
    far.eye = far.eye * 30.f;
    poseAt(f, kAtFlake, &far);
    EXPECT_LT(f.scene->shapeCount, shapes / 2); // distant balls have no fine detail
}
