// The shots. A bar is 16 rows; every cut falls on a bar.
#include "show/length.h"
#include "show/scenes.h"

namespace odraz {

constexpr SceneEntry kScenes[kSceneCount] = {
    {.name = "stage", .pose = poseStage, .id = kStage},
};
static_assert(inOrder(kScenes, &SceneEntry::id, kSceneCount), "a row for every scene, in the enum's order");

// Rows count from the scene's start; eye, target, roll, field of view (a 35 mm lens is 37.8 degrees high).
// Keys may lie outside their shot, so that the camera moves from the first picture to the last.
static constexpr CameraKey kRound[] = {
    {-16, {-3.6f, 0.9f, 4.0f}, {0.1f, 0.9f, 0}, 0, 40},
    {16, {-2.4f, 1.3f, 4.9f}, {0, 0.75f, 0}, 0, 40},
    {52, {-0.3f, 1.5f, 5.3f}, {0, 0.65f, 0}, 0, 40},
    {88, {1.9f, 1.2f, 4.9f}, {0, 0.6f, 0}, 0, 40},
};

static constexpr Shot kShots[] = {
    {.row = 0, .scene = kStage, .storyRow = 0, .path = path(kRound), .fadeIn = 6, .fadeOut = 12},
};

const ShotList kFilm = {kShots, sizeof kShots / sizeof *kShots, kEndRow};

} // namespace odraz
