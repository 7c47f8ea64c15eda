// Tests that the film's protagonist, the point of light, is in every shot: itself, or its image in mirrors
// and glass.
#include "inside.h"
#include "show/point_of_light.h"
#include "tests/support/loaded_film.h"
#include "tests/support/sanitized.h"
#include "tests/support/shots.h"
#include "tests/support/traced_picture.h"

using namespace odraz;

constexpr int kMoments = 4; // in each shot
constexpr int kLeastPixels = 2;
constexpr float kBright = 0.2f; // share of white

// Returns how many pixels of the picture at a time the point of light makes bright. All other light is off.
static long pixelsAt(double seconds) {
    Posed now = poseAt(smallFilm().film, seconds);
    Scene &scene = *smallFilm().film.scene;
    scene.lightCount = 0, scene.fog = scene.lines = 0;
    scene.sky = {}, scene.shafts = {};
    scene.ambientLow = scene.ambientHigh = {};
    for (int i = 0; i < scene.shapeCount; ++i) scene.shapes[i].chart = -1; // no lightmap
    for (int i = 0; i < scene.materialCount; ++i) {
        Rgb &emit = scene.materials[i].emit;
        // The point is known by its colour (while a pen writes, it is the pen's tip)
        bool point = emit.x > 1 && length(emit * (kPointLight.x / emit.x) - kPointLight) < 1e-3f;
        if (!point) emit = {};
    }
    const Quality middles = {.grid = 1, .depth = 5, .cutoff = 0.01f}; // one sample in each pixel's middle
    TracedPicture p = traced(scene, now.input.camera, middles, 1280, 720);
    std::vector<float> red = planeOf(p.frame, 0);
    return std::count_if(red.begin(), red.end(), [&](float r) { return r * scene.exposure > kBright; });
}

FIGURES_TEST(PointOfLight, IsSeenInEveryShot) {
    for (int i = 0; i < kFilm.count; ++i) {
        const Shot &s = kFilm.shots[i];
        for (int k = 0; k < kMoments; ++k) {
            double row = s.row + (endOf(i) - s.row) * (k + 0.5) / kMoments;
            EXPECT_GE(pixelsAt(row / kRowsPerSecond), kLeastPixels)
                << "shot " << i << " on row " << s.row << ", " << kScenes[s.scene].name << ", at "
                << row / kRowsPerSecond << " s";
        }
    }
}

// Within a shot it never jumps.
TEST(PointOfLight, MovesWithoutJumps) {
    constexpr double kStep = 1 / 60.;
    for (double t = kStep; t < duration(); t += kStep) {
        const Shot *before = momentAt(kFilm, (t - kStep) * kRowsPerSecond).shot,
                   *now = momentAt(kFilm, t * kRowsPerSecond).shot;
        if (before != now) continue;
        EXPECT_LT(length(pointAt(t).at - pointAt(t - kStep).at), 0.5f) << t << " s"; // 30 m/s
    }
}
