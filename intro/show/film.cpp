// The film's scenes and shots. A bar is 16 rows, a beat 4; every cut is on a beat.
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
     .pace = Pace{.cost = 0.35f, .halving = 1.4f, .penalty = {0, 0.1f, 0.3f, 0.5f, 0.8f}}},
    {.name = "table",
     .pose = poseTable,
     .id = kTable,
     .pace = Pace{.cost = 0.93f, .halving = 0.9f, .penalty = {0, 0.5f, 1.5f, 2.5f, 25}}},
    {.name = "flake",
     .pose = poseFlake,
     .id = kFlake,
     .pace = Pace{.cost = 0.65f, .penalty = {0, 0.5f, 1.7f, 2.1f, 9}}},
    {.name = "patches",
     .pose = posePatches,
     .letter = letterPatches,
     .id = kPatches,
     .needsHall = true,
     .pace = Pace{.leastWidth = 1280, .cost = 0.39f, .halving = 2.5f, .penalty = {0, 1, 3, 4, 10}}},
    {.name = "hall",
     .pose = poseDay,
     .id = kHall,
     .needsHall = true,
     .pace = Pace{.cost = 0.49f, .halving = 1.6f, .penalty = {0, 0.9f, 6, 9, 12}}},
    {.name = "odraz",
     .pose = poseOdraz,
     .id = kOdraz,
     .needsHall = true,
     .pace = Pace{.cost = 1.05f, .halving = 1.3f, .penalty = {0, 2, 25, 25, 25}}},
    {.name = "credits",
     .pose = poseCredits,
     .letter = letterCredits,
     .id = kCredits,
     .pace = Pace{.leastWidth = 1280, .cost = 0.33f, .halving = 2.4f, .penalty = {0, 0.3f, 0.8f, 1.5f, 3}}},
};
static_assert(inOrder(kScenes, &SceneEntry::id, kSceneCount), "a row for every scene, in the enum's order");

#include "show/film.keys"

static KEYED Shot kShots[] = {
    {.row = 0, .scene = kPoint, .storyRow = 0, .path = path(kTwoDots), .fadeIn = 2, .fadeOut = 0},
    {.row = 32, .scene = kPoint, .storyRow = 0, .path = path(kRoundTheBall), .fadeIn = 0, .fadeOut = 0},
    {.row = 60, .scene = kPoint, .storyRow = 0, .path = path(kWriting), .fadeIn = 0, .fadeOut = 0},
    {.row = 96, .scene = kTable, .storyRow = 96, .path = path(kTableWide), .fadeIn = 0, .fadeOut = 0},
    {.row = 144, .scene = kTable, .storyRow = 96, .path = path(kCaustic), .fadeIn = 0, .fadeOut = 0},
    {.row = 192, .scene = kTable, .storyRow = 96, .path = path(kCopperInsert), .fadeIn = 0, .fadeOut = 0},
    {.row = 208, .scene = kTable, .storyRow = 96, .path = path(kDarkInsert), .fadeIn = 0, .fadeOut = 0},
    {.row = 224, .scene = kTable, .storyRow = 96, .path = path(kSwallow), .fadeIn = 0, .fadeOut = 0},
    {.row = 256, .scene = kFlake, .storyRow = 256, .path = path(kBare), .fadeIn = 0, .fadeOut = 0},
    {.row = 272, .scene = kFlake, .storyRow = 256, .path = path(kGrowing), .fadeIn = 0, .fadeOut = 0},
    {.row = 320, .scene = kFlake, .storyRow = 256, .path = path(kUnder), .fadeIn = 0, .fadeOut = 0},
    {.row = 368, .scene = kFlake, .storyRow = 256, .path = path(kGate), .fadeIn = 0, .fadeOut = 0},
    {.row = 416, .scene = kFlake, .storyRow = 256, .path = path(kWhole), .fadeIn = 0, .fadeOut = 0},
    {.row = 448, .scene = kPatches, .storyRow = 448, .path = path(kWire), .fadeIn = 0, .fadeOut = 0},
    {.row = 480, .scene = kPatches, .storyRow = 448, .path = path(kVisit), .fadeIn = 0, .fadeOut = 0},
    {.row = 512, .scene = kPatches, .storyRow = 448, .path = path(kDirect), .fadeIn = 0, .fadeOut = 0},
    {.row = 528, .scene = kPatches, .storyRow = 448, .path = path(kFirstBounce), .fadeIn = 0, .fadeOut = 0},
    {.row = 544, .scene = kPatches, .storyRow = 448, .path = path(kSecondBounce), .fadeIn = 0, .fadeOut = 0},
    {.row = 560, .scene = kPatches, .storyRow = 448, .path = path(kThirdBounce), .fadeIn = 0, .fadeOut = 0},
    {.row = 576, .scene = kPatches, .storyRow = 448, .path = path(kInside), .fadeIn = 0, .fadeOut = 0},
    {.row = 624, .scene = kPatches, .storyRow = 448, .path = path(kBallComes), .fadeIn = 0, .fadeOut = 0},
    {.row = 656, .scene = kHall, .storyRow = 656, .path = path(kDescent), .fadeIn = 0, .fadeOut = 0},
    {.row = 704, .scene = kHall, .storyRow = 656, .path = path(kSunsetBall), .fadeIn = 0, .fadeOut = 0},
    {.row = 736, .scene = kHall, .storyRow = 656, .path = path(kLanternLight), .fadeIn = 0, .fadeOut = 0},
    {.row = 768, .scene = kHall, .storyRow = 656, .path = path(kLampsDie), .fadeIn = 0, .fadeOut = 0},
    {.row = 784, .scene = kHall, .storyRow = 656, .path = path(kNightDoor), .fadeIn = 0, .fadeOut = 0},
    {.row = 816, .scene = kHall, .storyRow = 656, .path = path(kDeadDoor), .fadeIn = 0, .fadeOut = 0},
    {.row = 832, .scene = kHall, .storyRow = 656, .path = path(kStripsWake), .fadeIn = 0, .fadeOut = 0},
    {.row = 864, .scene = kHall, .storyRow = 656, .path = path(kDoorPlays), .fadeIn = 0, .fadeOut = 0},
    {.row = 896, .scene = kOdraz, .storyRow = 896, .path = path(kMeet), .fadeIn = 0, .fadeOut = 0},
    {.row = 928, .scene = kOdraz, .storyRow = 896, .path = path(kInTheGlass), .fadeIn = 0, .fadeOut = 0},
    {.row = 944, .scene = kOdraz, .storyRow = 896, .path = path(kSilhouettes), .fadeIn = 0, .fadeOut = 0},
    {.row = 960, .scene = kOdraz, .storyRow = 896, .path = path(kRide), .fadeIn = 0, .fadeOut = 0},
    {.row = 976, .scene = kOdraz, .storyRow = 896, .path = path(kFromAbove), .fadeIn = 0, .fadeOut = 0},
    {.row = 992, .scene = kOdraz, .storyRow = 896, .path = path(kHalfCircle), .fadeIn = 0, .fadeOut = 0},
    {.row = 1024, .scene = kTable, .storyRow = 896, .path = path(kRecallTable), .fadeIn = 0, .fadeOut = 0},
    {.row = 1028, .scene = kFlake, .storyRow = 844, .path = path(kRecallFlake), .fadeIn = 0, .fadeOut = 0},
    {.row = 1032,
     .scene = kPatches,
     .storyRow = 764,
     .path = path(kRecallPatches),
     .fadeIn = 0,
     .fadeOut = 0},
    {.row = 1036, .scene = kHall, .storyRow = 996, .path = path(kRecallDay), .fadeIn = 0, .fadeOut = 0},
    {.row = 1040, .scene = kOdraz, .storyRow = 896, .path = path(kCopperDetail), .fadeIn = 0, .fadeOut = 0},
    {.row = 1044, .scene = kOdraz, .storyRow = 896, .path = path(kGlassDetail), .fadeIn = 0, .fadeOut = 0},
    {.row = 1048, .scene = kOdraz, .storyRow = 896, .path = path(kMirrorDetail), .fadeIn = 0, .fadeOut = 0},
    {.row = 1052, .scene = kOdraz, .storyRow = 896, .path = path(kStripDetail), .fadeIn = 0, .fadeOut = 0},
    {.row = 1056, .scene = kOdraz, .storyRow = 896, .path = path(kEverything), .fadeIn = 0, .fadeOut = 0},
    {.row = 1088, .scene = kOdraz, .storyRow = 896, .path = path(kOneIsLeft), .fadeIn = 0, .fadeOut = 0},
    {.row = 1120, .scene = kOdraz, .storyRow = 896, .path = path(kFallIn), .fadeIn = 0, .fadeOut = 0},
    {.row = 1184, .scene = kCredits, .storyRow = 1184, .path = path(kFallThrough), .fadeIn = 0, .fadeOut = 4},
};

const ShotList kFilm = {kShots, sizeof kShots / sizeof *kShots, kEndRow};

} // namespace odraz
