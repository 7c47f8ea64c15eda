// The film's scenes and shots. A bar is 16 rows; every cut is on a bar.
#include "show/length.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

// `.pace`: the penalties were computed from the errors of `play` and of in-betweens that build/probe prints
// at 1280x720, then adjusted by hand for the best result on machines that execute 16 to 64 G instructions a
// second. `.halving` follows from the counted costs.
constexpr SceneEntry kScenes[kSceneCount] = {
    {.name = "point",
     .pose = posePoint,
     .id = kPoint,
     .pace = Pace{.halving = 1.4f, .penalty = {0, 0.1f, 0.3f, 0.5f, 0.8f}}},
    {.name = "table",
     .pose = poseTable,
     .id = kTable,
     .pace = Pace{.halving = 0.9f, .penalty = {0, 0.5f, 1.5f, 2.5f, 25}}},
    {.name = "flake", .pose = poseFlake, .id = kFlake, .pace = Pace{.penalty = {0, 0.5f, 1.7f, 2.1f, 9}}},
    {.name = "patches",
     .pose = posePatches,
     .letter = letterPatches,
     .id = kPatches,
     .needsHall = true,
     .pace = Pace{.leastWidth = 1280, .halving = 2.5f, .penalty = {0, 1, 3, 4, 10}}},
    {.name = "hall",
     .pose = poseDay,
     .id = kHall,
     .needsHall = true,
     .pace = Pace{.halving = 1.6f, .penalty = {0, 0.9f, 6, 9, 12}}},
    {.name = "odraz",
     .pose = poseOdraz,
     .id = kOdraz,
     .needsHall = true,
     .pace = Pace{.leastWidth = 1152, .halving = 1.3f, .penalty = {0, 0.9f, 2.2f, 2.8f, 15}}},
    {.name = "credits",
     .pose = poseCredits,
     .letter = letterCredits,
     .id = kCredits,
     .pace = Pace{.leastWidth = 1280, .halving = 2.4f, .penalty = {0, 0.3f, 0.8f, 1.5f, 3}}},
};
static_assert(inOrder(kScenes, &SceneEntry::id, kSceneCount), "a row for every scene, in the enum's order");

#include "show/film.keys"

static KEYED Shot kShots[] = {
    {.row = 0, .scene = kPoint, .storyRow = 0, .path = path(kPushIn), .fadeIn = 2, .fadeOut = 0},
    {.row = 128, .scene = kTable, .storyRow = 128, .path = path(kTableWide), .fadeIn = 0, .fadeOut = 0},
    {.row = 192, .scene = kTable, .storyRow = 128, .path = path(kCaustic), .fadeIn = 0, .fadeOut = 0},
    {.row = 256, .scene = kTable, .storyRow = 128, .path = path(kSink), .fadeIn = 0, .fadeOut = 0},
    {.row = 320, .scene = kFlake, .storyRow = 320, .path = path(kGrowing), .fadeIn = 0, .fadeOut = 0},
    {.row = 384, .scene = kFlake, .storyRow = 320, .path = path(kUnder), .fadeIn = 0, .fadeOut = 0},
    {.row = 432, .scene = kFlake, .storyRow = 320, .path = path(kOver), .fadeIn = 0, .fadeOut = 0},
    {.row = 480, .scene = kFlake, .storyRow = 320, .path = path(kWhole), .fadeIn = 0, .fadeOut = 1.5f},
    {.row = 512, .scene = kPatches, .storyRow = 512, .path = path(kVisit), .fadeIn = 0, .fadeOut = 0},
    {.row = 656, .scene = kPatches, .storyRow = 512, .path = path(kWalkIn), .fadeIn = 0, .fadeOut = 0},
    {.row = 704, .scene = kPatches, .storyRow = 512, .path = path(kSunPatches), .fadeIn = 0, .fadeOut = 0},
    {.row = 736, .scene = kHall, .storyRow = 736, .path = path(kAtDawn), .fadeIn = 0, .fadeOut = 0},
    {.row = 800, .scene = kHall, .storyRow = 736, .path = path(kBeams), .fadeIn = 0, .fadeOut = 0},
    {.row = 848, .scene = kHall, .storyRow = 736, .path = path(kEveningLight), .fadeIn = 0, .fadeOut = 0},
    {.row = 880, .scene = kHall, .storyRow = 736, .path = path(kLanternLight), .fadeIn = 0, .fadeOut = 0},
    {.row = 912, .scene = kHall, .storyRow = 736, .path = path(kNightfall), .fadeIn = 0, .fadeOut = 0},
    {.row = 944, .scene = kHall, .storyRow = 736, .path = path(kToTheDoor), .fadeIn = 0, .fadeOut = 0},
    {.row = 992, .scene = kHall, .storyRow = 736, .path = path(kGlare), .fadeIn = 0, .fadeOut = 0},
    {.row = 1024, .scene = kOdraz, .storyRow = 1024, .path = path(kMeet), .fadeIn = 0, .fadeOut = 0},
    {.row = 1072, .scene = kOdraz, .storyRow = 1024, .path = path(kCrane), .fadeIn = 0, .fadeOut = 0},
    {.row = 1136, .scene = kOdraz, .storyRow = 1024, .path = path(kFallIn), .fadeIn = 0, .fadeOut = 0},
    {.row = 1216, .scene = kCredits, .storyRow = 1216, .path = path(kFallThrough), .fadeIn = 0, .fadeOut = 0},
};

const ShotList kFilm = {kShots, sizeof kShots / sizeof *kShots, kEndRow};

} // namespace odraz
