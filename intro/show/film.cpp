// The shots. A bar is 16 rows; every cut falls on a bar.
#include "base/maths.h"
#include "show/length.h"
#include "show/scenes.h"

#include <initializer_list>

namespace odraz {

// The penalties were measured by build/seen at `play` and near `film`, then adjusted by hand for the best
// result on machines of 16 to 64 G instructions a second. tools/measure/seen/costs measures how much work a
// step of coarseness saves.
constexpr SceneEntry kScenes[kSceneCount] = {
    {.name = "point",
     .pose = posePoint,
     .id = kPoint,
     .pace = Pace{.halving = 1.7f, .penalty = {0, 0.4f, 0.7f, 0.7f, 1.2f}}},
    {.name = "table", .pose = poseTable, .id = kTable, .pace = Pace{.penalty = {0, 0.4f, 1, 1.3f, 3.5f}}},
    {.name = "flake", .pose = poseFlake, .id = kFlake, .pace = Pace{.penalty = {0, 0.5f, 1.7f, 2.1f, 9}}},
    {.name = "patches",
     .pose = posePatches,
     .letter = letterPatches,
     .id = kPatches,
     .needsHall = true,
     .pace = Pace{.leastWidth = 1280, .halving = 2.5f, .penalty = {0, 0.5f, 1.6f, 2.1f, 8.2f}}},
    {.name = "hall",
     .pose = poseDay,
     .id = kHall,
     .needsHall = true,
     .pace = Pace{.halving = 2.4f, .penalty = {0, 0.5f, 1.3f, 1.8f, 1.6f}}},
    {.name = "odraz",
     .pose = poseOdraz,
     .id = kOdraz,
     .needsHall = true,
     .pace = Pace{.leastWidth = 1280, .halving = 1.1f, .penalty = {0, 0.6f, 2, 2.1f, 1.5f}}},
    {.name = "credits",
     .pose = poseCredits,
     .letter = letterCredits,
     .id = kCredits,
     .pace = Pace{.leastWidth = 1280, .halving = 1.6f, .penalty = {0, 0.1f, 0.1f, 0.3f, 0.6f}}},
};
static_assert(inOrder(kScenes, &SceneEntry::id, kSceneCount), "a row for every scene, in the enum's order");

// Rows count from the scene's start; eye, target, roll, field of view (a 35 mm lens is 37.8 degrees high).
// Keys may lie outside their shot, so that the camera moves from the first picture to the last.
static constexpr CameraKey kPushIn[] = {
    {-64, {0.9f, 0.86f, 5.1f}, {0.0f, 0.60f, 0}, 0, 37.8f},
    {192, {0.05f, 0.64f, 3.3f}, {0.22f, 0.50f, 0}, 0, 37.8f},
};

// Keys whose numbers have so few significant bits that they pack well. It is the paths' smoothness that the
// eye sees, not where their keys lie to the millimetre.
template <int N> struct Keys { CameraKey key[N]; };
template <int kBits = 8, int N> static consteval Keys<N> coarse(const CameraKey (&keys)[N]) {
    constexpr int kUnit = 1 << (24 - kBits);
    auto round = [](float &x) { x = fromBits((bits(x) + kUnit / 2) & -kUnit); };
    Keys<N> to = {};
    for (int i = 0; i < N; ++i) {
        CameraKey k = keys[i];
        for (float *x : {&k.eye.x, &k.eye.y, &k.eye.z, &k.target.x, &k.target.y, &k.target.z, &k.fov})
            round(*x);
        to.key[i] = k;
    }
    return to;
}

// A place for paths around the y axis: degrees around it, distance from it, height.
static consteval Vec3 place(float degrees, float away, float height) {
    float angle = degrees * (kPi / 180);
    return {away * __builtin_cosf(angle), height, away * __builtin_sinf(angle)};
}
static consteval CameraKey around(float row, float degrees, float away, float height, float aim, float fov) {
    return {row, place(degrees, away, height), {0, aim, 0}, 0, fov};
}

// The table in three shots. The first walks round it with the sun behind.
static constexpr auto kTableWide = coarse({
    {0, {0, 1.47f, 6.19f}, {-0.767f, 0.854f, 0}, 0, 36},
    {32, {2, 1.32f, 5.56f}, {-0.45f, 0.834f, 0}, 0, 36},
    {64, {3.47f, 1.15f, 4.14f}, {0.2f, 0.8f, 0}, 0, 36},
});
// The second, against the sun, goes with a glass ball and the light that it throws on the board.
static constexpr auto kCaustic = coarse({
    {64, {2.78f, 0.6f, -0.19f}, {1.93f, 0.1f, -0.1f}, 0, 36},
    {80, {2.73f, 0.64f, 0.53f}, {1.63f, 0.12f, 0.59f}, 0, 36.5f},
    {96, {2.4f, 0.67f, 1.06f}, {1.05f, 0.15f, 1.09f}, 0, 37},
    {112, {1.91f, 0.7f, 1.29f}, {0.31f, 0.18f, 1.29f}, 0, 37.5f},
    {128, {1.41f, 0.74f, 1.18f}, {-0.44f, 0.2f, 1.16f}, 0, 38},
});
// The third sinks until it is just above the board and faces the sun; from above, the dark ball passes below
// the hero, not before it.
static constexpr auto kSink = coarse<12>({
    around(128, 5.9f, 5.0f, 2.6f, 0.48f, 38.7f),
    around(144, -5, 4.4f, 1.95f, 0.55f, 40),
    around(152, -10.2f, 4.1f, 1.35f, 0.58f, 40.9f),
    around(160, -15.5f, 3.78f, 0.75f, 0.59f, 42),
    around(168, -21.2f, 3.55f, 0.33f, 0.594f, 43.2f),
    around(176, -27.3f, 3.33f, 0.272f, 0.6f, 44.3f),
    around(192, -40, 3.0f, 0.2f, 0.6f, 46),
    around(240, -75, 2.6f, 0.2f, 0.6f, 46),
});

// The flake: while it grows;
static constexpr auto kGrowing = coarse({
    {0, {4.57f, 1.84f, -13.4f}, {-2.14f, 2.7f, -0.888f}, 0, 40},
    {32, {7.92f, 2.19f, -10.4f}, {-1.73f, 2.91f, -1.38f}, 0, 40},
    {64, {10.3f, 2.64f, -6.61f}, {-1.07f, 3.06f, -1.68f}, 0, 40},
});
// low, under its lower balls and up between two of them;
static constexpr auto kUnder = coarse({
    {64, {-3.86f, 0.8f, -3.48f}, {-2.17f, 1.7f, 0.38f}, -3, 52},
    {76, {-3.92f, 0.5f, -1.51f}, {-2.03f, 2, 1.08f}, -8, 52},
    {88, {-3.4f, 0.8f, 0.18f}, {-1.54f, 2.8f, 1.84f}, -12, 52},
    {100, {-2.89f, 2.15f, 0.98f}, {-1.14f, 3.9f, 2.34f}, -10, 52},
    {112, {-2.85f, 3.7f, 1.21f}, {-0.7f, 4.9f, 2.81f}, -2, 52},
});
// over the top, between the three upper balls, towards the sun;
static constexpr auto kOver = coarse({
    {112, {5.64f, 4.7f, -2.05f}, {-1.3f, 5.2f, 0.75f}, -5, 50},
    {124, {3.99f, 5.1f, -1.3f}, {-1.7f, 5.3f, 1.06f}, -1, 50},
    {136, {2.31f, 5.65f, -0.66f}, {-2.05f, 5.3f, 1.6f}, 4, 50},
    {148, {0.85f, 6.05f, -0.03f}, {-2.60f, 5.2f, 2.19f}, 9, 50},
    {160, {-0.12f, 6.1f, 1.14f}, {-3.73f, 5.1f, 2.33f}, 12, 50},
});
// and away, until it is seen whole.
static constexpr auto kWhole = coarse({
    {160, {-5.83f, 1.5f, -3.1f}, {-0.56f, 2.8f, -0.21f}, 0, 45},
    {176, {-8.23f, 1.7f, -4.94f}, {-0.31f, 2.9f, 0.85f}, 0, 43},
    {192, {-10.9f, 1.9f, -7.38f}, {-0.44f, 3, 1.22f}, 0, 41},
});

// The patches from outside, through long lenses: down to one, whose half-cube fills the picture, and out as
// light comes;
static constexpr auto kVisit = coarse({
    {0, {37.7f, 27.1f, 34.6f}, {0, 2.33f, 0.26f}, 0, 17.4f},
    {16, {37.1f, 27.3f, 35.4f}, {0.8f, 1.93f, 0}, 0, 13.9f},
    {32, {36.3f, 27.5f, 36.3f}, {1.9f, 1.3f, -0.6f}, 0, 8.8f},
    {48, {35.6f, 27.6f, 37}, {2.2f, 1, -1.4f}, 0, 7},
    {72, {34.6f, 27.8f, 38}, {2.3f, 1, -1.5f}, 0, 6.7f},
    {96, {33.3f, 28.2f, 39.1f}, {1.39f, 1.68f, -0.669f}, 0, 13.8f},
});
// the bounces from the other end;
static constexpr auto kAcross = coarse({
    {80, {28, 31, -41}, {-0.6f, 2.0f, 0.4f}, 0, 16},
    {160, {42, 29, -28}, {-0.6f, 2.1f, -0.4f}, 0, 14.4f},
});
// and in.
static constexpr auto kWalkIn = coarse({
    {144, {0.6f, 1.7f, 11.8f}, {-0.4f, 2.3f, 0}, 0, 44},
    {192, {0.5f, 1.6f, 7.4f}, {-0.8f, 2.3f, -4}, 0, 46},
});
static constexpr auto kSunPatches = coarse({
    {176, {0.9f, 1.3f, -7.6f}, {-0.9f, 2.0f, 0}, 0, 46},
    {240, {0.3f, 1.5f, -4.4f}, {-1.1f, 2.3f, 4}, 0, 46},
});
// A day in the hall, cut where it turns: low, towards the windows, at dawn; down the nave, past the beams;
// across the evening's light, and then with it, to the lanterns; low again in the night; to the door.
static constexpr CameraKey kAtDawn[] = {
    {-16, {2.7f, 0.35f, -4.0f}, {-4.5f, 1.9f, -0.2f}, 0, 50},
    {80, {1.6f, 0.45f, -2.0f}, {-4.5f, 2.1f, 1.0f}, 0, 50},
};
static constexpr CameraKey kBeams[] = {
    {0, {1.0f, 1.6f, 8.5f}, {-3.4f, 2.4f, 1.2f}, 0, 48},
    {64, {0.95f, 1.6f, 6.6f}, {-3.4f, 2.2f, -0.8f}, 0, 48},
    {112, {0.95f, 1.6f, 5.2f}, {-3.8f, 2.5f, -2.0f}, 0, 48},
    {144, {1.0f, 1.6f, 4.2f}, {-4.2f, 2.7f, -3.4f}, 0, 48},
};
static constexpr CameraKey kEveningLight[] = {
    {112, {1.5f, 0.8f, -6.6f}, {-2.6f, 1.9f, 1.0f}, 0, 50},
    {176, {1.2f, 1.1f, -5.0f}, {-2.8f, 1.9f, 2.4f}, 0, 50},
};
static constexpr CameraKey kLanternLight[] = {
    {144, {-1.1f, 1.1f, 8.6f}, {2.0f, 2.7f, -2.6f}, 0, 48},
    {208, {-1.3f, 1.3f, 7.0f}, {2.0f, 2.8f, -3.6f}, 0, 48},
};
static constexpr CameraKey kNightfall[] = {
    {176, {1.6f, 0.5f, 6.4f}, {-4.5f, 0.8f, 2.4f}, 0, 50},
    {240, {1.2f, 0.6f, 4.6f}, {-4.5f, 0.9f, 0.6f}, 0, 50},
};
// To the door, and on when the balls come out of it: one straight path through two scenes, whose keys count
// from the start of either.
static consteval Keys<2> toTheDoor(float since) {
    return {{{208 - since, {0, 1.6f, 3.0f}, {0, 2.15f, -9}, 0, 42},
             {352 - since, {0, 1.3f, -0.4f}, {0, 1.6f, -9}, 0, 42}}};
}
static constexpr Keys<2> kToTheDoor = toTheDoor(0), kMeet = toTheDoor(288);
// From the floor up and back, until the balls' shadows are seen; then down, and into the one that stays.
static constexpr CameraKey kCrane[] = {
    {32, {0.9f, -0.4f, -3.2f}, {0, 2, -10}, 0, 44},
    {128, {-0.9f, 4.5f, 4}, {0, -0.3f, -4}, 0, 44},
};
static constexpr CameraKey kFallIn[] = {
    {96, {1.9f, 2.4f, -0.9f}, {-0.2f, 0.7f, -5.6f}, 0, 41},
    {152, {0.5f, 1.6f, -1.7f}, {0, 0.8f, -5.1f}, 0, 38},
    {192, {0.1f, 0.9f, -3.8f}, {0, 0.76f, -5}, 0, 36},
};

// The word in the last ball becomes the word on the marble: of the same size, at the same place.
static constexpr CameraKey kFallThrough[] = {
    {0, {0.274f, 0.95f, 6.35f}, {0.274f, 0.834f, 0}, 0, 37.8f},
    {10, {0.f, 0.85f, 5.06f}, {0.07f, 0.76f, 0}, 0, 37.8f},
    {24, {-0.2f, 0.79f, 4.36f}, {-0.08f, 0.72f, 0}, 0, 37.8f},
    {48, {-0.41f, 0.76f, 4.03f}, {-0.2f, 0.7f, 0}, 0, 37.8f},
    {80, {-0.64f, 0.75f, 3.89f}, {-0.32f, 0.69f, 0}, 0, 37.8f},
};

static constexpr Shot kShots[] = {
    {.row = 0, .scene = kPoint, .storyRow = 0, .path = path(kPushIn), .fadeIn = 2, .fadeOut = 0},
    {.row = 128, .scene = kTable, .storyRow = 128, .path = path(kTableWide.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 192, .scene = kTable, .storyRow = 128, .path = path(kCaustic.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 256, .scene = kTable, .storyRow = 128, .path = path(kSink.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 320, .scene = kFlake, .storyRow = 320, .path = path(kGrowing.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 384, .scene = kFlake, .storyRow = 320, .path = path(kUnder.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 432, .scene = kFlake, .storyRow = 320, .path = path(kOver.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 480, .scene = kFlake, .storyRow = 320, .path = path(kWhole.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 512, .scene = kPatches, .storyRow = 512, .path = path(kVisit.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 608, .scene = kPatches, .storyRow = 512, .path = path(kAcross.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 656, .scene = kPatches, .storyRow = 512, .path = path(kWalkIn.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 704,
     .scene = kPatches,
     .storyRow = 512,
     .path = path(kSunPatches.key),
     .fadeIn = 0,
     .fadeOut = 0},
    {.row = 736, .scene = kHall, .storyRow = 736, .path = path(kAtDawn), .fadeIn = 0, .fadeOut = 0},
    {.row = 800, .scene = kHall, .storyRow = 736, .path = path(kBeams), .fadeIn = 0, .fadeOut = 0},
    {.row = 864, .scene = kHall, .storyRow = 736, .path = path(kEveningLight), .fadeIn = 0, .fadeOut = 0},
    {.row = 896, .scene = kHall, .storyRow = 736, .path = path(kLanternLight), .fadeIn = 0, .fadeOut = 0},
    {.row = 928, .scene = kHall, .storyRow = 736, .path = path(kNightfall), .fadeIn = 0, .fadeOut = 0},
    {.row = 960, .scene = kHall, .storyRow = 736, .path = path(kToTheDoor.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 1024, .scene = kOdraz, .storyRow = 1024, .path = path(kMeet.key), .fadeIn = 0, .fadeOut = 0},
    {.row = 1072, .scene = kOdraz, .storyRow = 1024, .path = path(kCrane), .fadeIn = 0, .fadeOut = 0},
    {.row = 1136, .scene = kOdraz, .storyRow = 1024, .path = path(kFallIn), .fadeIn = 0, .fadeOut = 0},
    {.row = 1216, .scene = kCredits, .storyRow = 1216, .path = path(kFallThrough), .fadeIn = 0, .fadeOut = 0},
};

const ShotList kFilm = {kShots, sizeof kShots / sizeof *kShots, kEndRow};

} // namespace odraz
