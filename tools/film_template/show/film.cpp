// The shots. A bar is 16 rows; every cut falls on a bar.
#include "show/length.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

constexpr SceneEntry kScenes[kSceneCount] = {
    {.name = "stage", .pose = poseStage, .id = kStage},
};
static_assert(inOrder(kScenes, &SceneEntry::id, kSceneCount), "a row for every scene, in the enum's order");

#include "show/film.keys"

static KEYED Shot kShots[] = {
    {.row = 0, .scene = kStage, .storyRow = 0, .path = path(kRound), .fadeIn = 6, .fadeOut = 12},
};

const ShotList kFilm = {kShots, sizeof kShots / sizeof *kShots, kEndRow};

} // namespace odraz
