// The shots. A bar is 16 rows; every cut falls on a bar.
#include "base/maths.h"
#include "show/length.h"
#include "show/show.h"

namespace odraz {

// What scenes would rather do without was found by build/seen, with two cores and 1280x720 in mind: details
// of most are worth more than half of the pictures. The hall is as good with all of them.
constexpr SceneEntry kScenes[kSceneCount] = {
    {.name = "point", .pose = posePoint, .id = kPoint},
    {.name = "table", .pose = poseTable, .id = kTable, .fewerPixels = 19, .thirty = 12},
    {.name = "flake", .pose = poseFlake, .id = kFlake, .thirty = 12},
    {.name = "patches",
     .pose = posePatches,
     .letter = letterPatches,
     .id = kPatches,
     .needsHall = true,
     .fewerPixels = 15,
     .thirty = 10},
    {.name = "hall", .pose = poseDay, .id = kHall, .needsHall = true, .fewerPixels = 19, .thirty = 12},
    {.name = "odraz", .pose = poseOdraz, .id = kOdraz, .needsHall = true, .thirty = 12, .leastWidth = 80},
    {.name = "credits",
     .pose = poseCredits,
     .letter = letterCredits,
     .id = kCredits,
     .thirty = 15,
     .leastWidth = 80},
};
static_assert(inOrder(kScenes, &SceneEntry::id, kSceneCount), "a row for every scene, in the enum's order");

// Rows count from the scene's start; eye, target, roll, field of view (a 35 mm lens is 37.8 degrees high).
// Keys may lie outside their shot, so that the camera moves from the first picture to the last.
static constexpr CameraKey kPushIn[] = {
    {-64, {0.9f, 0.86f, 5.1f}, {0.0f, 0.60f, 0}, 0, 37.8f},
    {192, {0.05f, 0.64f, 3.3f}, {0.22f, 0.50f, 0}, 0, 37.8f},
};

// A place for paths around the y axis: degrees around it, distance from it, height.
static consteval Vec3 place(float degrees, float away, float height) {
    float angle = degrees * (kPi / 180);
    return {away * __builtin_cosf(angle), height, away * __builtin_sinf(angle)};
}
static consteval CameraKey around(float row, float degrees, float away, float height, float aim, float fov) {
    return {row, place(degrees, away, height), {0, aim, 0}, 0, fov};
}
// The camera sinks until it is just above the table and faces the sun.
static constexpr CameraKey kOrbit[] = {
    around(-48, 128, 6.9f, 1.6f, 0.8f, 36), around(0, 93, 6.5f, 1.5f, 0.8f, 36),
    around(48, 60, 6.0f, 1.3f, 0.8f, 36),   around(96, 27, 5.3f, 0.95f, 0.7f, 37),
    around(144, -5, 4.2f, 0.5f, 0.6f, 40),  around(192, -40, 3.0f, 0.2f, 0.6f, 46),
    around(240, -75, 2.6f, 0.2f, 0.6f, 46),
};

// Towards the flake, and into the valley between its lower and its upper balls.
static consteval CameraKey valley(float row, float degrees, float away, float height) {
    return {row, place(degrees, away, height), place(degrees + 50, away * 0.62f, height - 0.25f), 0, 50};
}
static constexpr CameraKey kValley[] = {
    {-32, place(-52, 15.2f, 2.4f), {0, 2.7f, 0}, 0, 40},
    {0, place(-48, 10.9f, 2.9f), {0, 2.8f, 0}, 0, 40},
    {32, place(-36, 6.8f, 3.6f), place(30, 1.2f, 3.2f), 0, 44},
    valley(64, 6, 3.9f, 4.15f),
    valley(88, 58, 3.75f, 4.3f),
    valley(112, 111, 3.75f, 4.15f),
    valley(136, 164, 3.75f, 4.3f),
    valley(160, 217, 3.8f, 4.2f),
    valley(184, 270, 3.8f, 4.3f),
    valley(208, 323, 3.8f, 4.2f),
    valley(232, 375, 3.9f, 4.45f),
    valley(256, 425, 4.2f, 4.8f),
    valley(280, 473, 4.8f, 5.4f),
};
static constexpr CameraKey kAxonometry[] = {
    {0, {39.5f, 27, 31.5f}, {1.8f, 2.0f, -1.2f}, 0, 17.5f},
    {176, {31.5f, 31, 37}, {2.4f, 2.0f, -1.8f}, 0, 17.5f},
};
static constexpr CameraKey kWalkIn[] = {
    {176, {0.6f, 1.7f, 11.8f}, {-0.4f, 2.3f, 0}, 0, 44},
    {224, {0.5f, 1.6f, 7.4f}, {-0.8f, 2.3f, -4}, 0, 46},
};
// Down the nave between the columns; the camera turns with the sun, up to the lamps, and to the door.
static constexpr CameraKey kWalk[] = {
    {0, {1.0f, 1.6f, 8.5f}, {-3.4f, 2.4f, 1.2f}, 0, 48},
    {64, {0.95f, 1.6f, 6.6f}, {-3.4f, 2.2f, -0.8f}, 0, 48},
    {112, {0.95f, 1.6f, 5.2f}, {-3.8f, 2.5f, -2.0f}, 0, 48},
    {144, {1.0f, 1.6f, 4.2f}, {-4.2f, 2.7f, -3.4f}, 0, 48},
    {168, {0.9f, 1.6f, 3.5f}, {-3.6f, 2.9f, -4.6f}, 0, 48},
    {196, {0.5f, 1.6f, 2.7f}, {-0.4f, 3.6f, -4.5f}, 0, 48},
    {228, {0.05f, 1.6f, 1.8f}, {0, 2.3f, -7}, 0, 47},
    {288, {0, 1.6f, 0.1f}, {0, 2.2f, -9}, 0, 46},
};
// Above the balls that come, then down to the one that stays.
static constexpr CameraKey kCrane[] = {
    {0, {-0.5f, 1.3f, 7.4f}, {0, 1.5f, -5}, 0, 42},     {64, {0.4f, 2.5f, 6.7f}, {0, 1.0f, -2}, 0, 42},
    {112, {0.7f, 2.7f, 5.4f}, {0, 0.8f, -0.6f}, 0, 41}, {152, {0.5f, 1.6f, 3.7f}, {0, 0.8f, 0.3f}, 0, 38},
    {192, {0.1f, 0.9f, 1.6f}, {0, 0.76f, 0.4f}, 0, 36},
};

static constexpr CameraKey kStill[] = {
    {0, {0.3f, 0.9f, 4.4f}, {0, 0.72f, 0}, 0, 37.8f},
    {80, {-0.1f, 0.8f, 4.0f}, {0, 0.72f, 0}, 0, 37.8f},
};

static constexpr Shot kShots[] = {
    {.row = 0, .scene = kPoint, .storyRow = 0, .path = path(kPushIn), .fadeIn = 2, .fadeOut = 0},
    {.row = 128, .scene = kTable, .storyRow = 128, .path = path(kOrbit), .fadeIn = 0, .fadeOut = 0},
    {.row = 320, .scene = kFlake, .storyRow = 320, .path = path(kValley), .fadeIn = 0, .fadeOut = 0},
    {.row = 512, .scene = kPatches, .storyRow = 512, .path = path(kAxonometry), .fadeIn = 8, .fadeOut = 0},
    {.row = 688, .scene = kPatches, .storyRow = 512, .path = path(kWalkIn), .fadeIn = 0, .fadeOut = 8},
    {.row = 736, .scene = kHall, .storyRow = 736, .path = path(kWalk), .fadeIn = 8, .fadeOut = 0},
    {.row = 1024, .scene = kOdraz, .storyRow = 1024, .path = path(kCrane), .fadeIn = 0, .fadeOut = 8},
    {.row = 1216, .scene = kCredits, .storyRow = 1216, .path = path(kStill), .fadeIn = 8, .fadeOut = 4},
};

const ShotList kFilm = {kShots, sizeof kShots / sizeof *kShots, kEndRow};

Posed poseAt(const Film &film, double seconds, const CameraKey *camera) {
    Moment m = momentAt(kFilm, seconds * kRowsPerSecond);
    Posed now = {&kScenes[m.shot->scene],
                 {m.storyRow, camera ? *camera : pose(m.shot->path, m.storyRow), film.hall, film.facts},
                 m.fade};
    film.scene->clear();
    now.entry->pose(now.cue, *film.scene);
    film.scene->finish();
    return now;
}

} // namespace odraz
