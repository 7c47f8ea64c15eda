// Balls of five materials on polished stone, in the evening sun. One of them falls and lands on the beat.
// Then a word of light is written in front of them, and the floor mirrors it.
#include "base/maths.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/stage.keys"

enum { kFloor, kSilver, kClear, kRed, kWood, kStone };
static constexpr const Material *kMaterials[] = {
    [kFloor] = &kHallFloor, [kSilver] = &kMirror, [kClear] = &kGlass,
    [kRed] = &kCopper,      [kWood] = &kOak,      [kStone] = &kDarkMarble};

static constexpr Shape kShapes[] = {
    plane({0, 0, 0}, kFloor),
    sphere({-0.75f, 0.8f, -0.5f}, 0.8f, kSilver),
    sphere({0.2f, 0.38f, 0.75f}, 0.38f, kClear),
    sphere({-1.75f, 0.34f, 0.55f}, 0.34f, kStone),
    sphere({2.15f, 0.4f, 0.25f}, 0.4f, kWood),
};

// The height, in metres, of a ball that falls from rest, lands, and bounces twice.
static float height(float row) {
    constexpr float kLandings[] = {rowOf(kBallLands), rowOf(kBallLandsAgain), rowOf(kBallLandsAgain) + 4};
    constexpr float kScale = 4.9f / (float)(kRowsPerSecond * kRowsPerSecond);
    float left = kLandings[0] - row;
    if (left > 0) return kScale * left * left;
    for (int i = 1; i < 3; ++i)
        if (row < kLandings[i]) return kScale * (kLandings[i] - row) * (row - kLandings[i - 1]);
    return 0;
}

void poseStage(const SceneInput &in, Scene &scene) {
    scene.addAll(kMaterials);
    scene.addAll(kShapes);
    float row = in.row;
    scene.add(sphere({1.05f, 0.5f + height(row), -0.3f}, 0.5f, kRed));

    // A longer word has smaller letters
    const char *word = "@NAME@";
    int letters = 0;
    while (word[letters]) ++letters;
    float unit = min(0.046f, 0.29f / (float)letters), written = row - rowOf(kWordComes);
    int tube = scene.add(lamp({2.6f, 0.9f, 0.27f}));
    addText(scene, word, {-5.6f * unit * (float)letters, 0.06f, 1.7f}, unit, 6 * written, tube);

    scene.add(Light{kDuskSun, {620, 390, 210}, 0.6f}); // 1.2 m wide: shadows are soft
    scene.ballsOcclude = true;
    scene.ambientLow = {0.06f, 0.045f, 0.045f};
    scene.ambientHigh = {0.09f, 0.12f, 0.19f};
    scene.sky = duskSky(row);
    scene.exposure = 1;
}

} // namespace odraz
