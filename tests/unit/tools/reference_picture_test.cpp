// Compares path tracing with closed forms: light on a bare floor, glass in an even sky, the shadow of a ball.
#include "tools/measure/oracle/reference_picture.h"

#include "tests/support/shapes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

using namespace odraz;
using namespace odraz::measure;

namespace {

constexpr int kSide = 16;

struct Room {
    std::unique_ptr<Scene> scene = emptyScene();
    View view = lookAt({0, 3, -0.5f}, {0, 0, 0.5f}, 0, 20, kSide, kSide);
    Workers workers = serialWorkers();

    explicit Room(float sky) { scene->ambientHigh = {sky, sky, sky}; }
    int matte(float grey) { return scene->add(odraz::matte({grey, grey, grey})); }
    int glass() { return scene->add(Material{.ior = 1.5f}); }
    std::vector<Vec3d> trace(int samples, bool bounces = false) {
        return tracePaths(*scene, view, {bounces, samples, 20, 1}, workers);
    }
};

double mean(const std::vector<Vec3d> &picture) {
    double sum = 0;
    for (const Vec3d &p : picture) sum += p.y;
    return sum / (double)picture.size();
}

} // namespace

TEST(ReferencePicture, LightsAFloorAsTheFilmDoes) {
    Room room(0.25f);
    room.scene->add(plane({0, 0, 0}, room.matte(0.5f)));
    room.scene->add(Light{{1, 4, 2}, {6, 6, 6}, 0.7f});
    // The difference is nowhere more than the noise of a thousand samples
    std::vector<Vec3d> picture = room.trace(1024);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            Vec3 d = room.view.direction((float)x + 0.5f, (float)y + 0.5f),
                 p = room.view.eye - d * (room.view.eye.y / d.y), to = Vec3{1, 4, 2} - p;
            float far = length(to), light = 0.5f * (0.25f + 6 * to.y / (far * far * far));
            EXPECT_NEAR(picture[(size_t)(y * kSide + x)].y, (double)light, 2e-3 * (double)light);
        }
}

TEST(ReferencePicture, ShowsNoGlassInAnEvenSky) {
    Room room(0.5f);
    room.scene->add(sphere({0, 0, 0}, 0.6f, room.glass()));
    for (const Vec3d &p : room.trace(16)) EXPECT_NEAR(p.y, 0.5, 1e-9);
}

TEST(ReferencePicture, LosesNoLightInWhite) {
    // White things reflect all light: in an even sky, with all bounces, they are as bright as the sky
    Room room(0.5f);
    room.scene->add(sphere({-0.3f, 0, 0.2f}, 0.3f, room.matte(1)));
    room.scene->add(sphere({0.3f, 0, 0.2f}, 0.3f, room.matte(1)));
    EXPECT_NEAR(mean(room.trace(64, true)), 0.5, 3e-4);
    EXPECT_LT(mean(room.trace(64, false)), 0.495);
}

TEST(ReferencePicture, GathersBehindGlassWhatMeetsIt) {
    // Glass between floor and lamp takes light away and returns it, except the 8 % that it reflects
    Room room(0);
    room.scene->add(plane({0, 0, 0}, room.matte(1)));
    room.scene->add(Light{{0, 40, 0}, {1600, 1600, 1600}, 0.5f});
    room.view = lookAt({0, 6, -0.01f}, {0, 0, 0}, 0, 25, kSide, kSide);
    double bare = mean(room.trace(64));
    room.scene->add(sphere({0, 0.75f, 0}, 0.5f, room.glass()));
    room.view = lookAt({0, -6, -0.01f}, {0, 0, 0}, 0, 25, kSide, kSide); // from below
    double gathered = mean(room.trace(64)) - bare, area = std::pow(12 * std::tan(12.5 * M_PI / 180), 2),
           meets = M_PI * 0.25 * std::pow(40 / 39.25, 2) / area * bare;
    EXPECT_NEAR(gathered, -0.16 * meets, 0.05 * meets);
}
