// Scene 1. Black; a single light wakes over dark veined marble; a glass ball, then a second, mirrored one.
#include "base/maths.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

using enum Interpolation;

static constexpr Key kKeyLight[] = {{rowOf(kLightIsBorn), 0, Smooth},
                                    {rowOf(kLightIsBorn) + 8, 0.035f, Smooth},
                                    {rowOf(kLightGrows), 0.02f, Smooth},
                                    {rowOf(kLightGrows) + 36, 1, Linear}};
static constexpr Key kRimLight[] = {{rowOf(kRimLightWakes), 0, Smooth},
                                    {rowOf(kRimLightWakes) + 48, 1, Linear}};
static constexpr Key kMirrorAt[] = {{rowOf(kMirrorRollsIn), 2.9f, Smooth},
                                    {rowOf(kMirrorRollsIn) + 56, 0.92f, Linear}}; // its x as it rolls in

enum { kMarble, kClear, kSilver };
static constexpr const Material *kMaterials[] = {&kDarkMarble, &kGlass, &kMirror};

void posePoint(const Cue &cue, Scene &scene) {
    float key = value(track(kKeyLight), cue.row), rim = value(track(kRimLight), cue.row);
    scene.addAll(kMaterials);
    int glow = scene.add(lamp(Rgb{2.6f, 2.2f, 1.6f} * (40 * (0.05f + key))));

    scene.add(plane({0, 0, 0}, kMarble))->textureShift = {3.1f, 0.37f, 1.9f};
    scene.add(sphere({-0.38f, 0.5f, 0.1f}, 0.5f, kClear));
    float x = value(track(kMirrorAt), cue.row);
    Shape *ball = scene.add(sphere({x, 0.36f, -0.42f}, 0.36f, kSilver));
    float turn = x / 0.36f;
    ball->frame = {{cos(turn), -sin(turn), 0}, {sin(turn), cos(turn), 0}, {0, 0, 1}};

    Vec3 point = {-1.12f, 1.22f, 0.3f};
    if (key > 0) scene.add(sphere(point, 0.022f, glow));
    scene.add(Light{point, Rgb{8.2f, 6.5f, 4.6f} * key, 0.06f});
    scene.add(Light{{2.6f, 1.7f, -2.6f}, Rgb{3.6f, 4.9f, 7.4f} * rim, 0.2f});
    scene.contact = true;
    scene.ambientLow = Rgb{0.012f, 0.012f, 0.016f} * key;
    scene.ambientHigh = Rgb{0.02f, 0.022f, 0.03f} * key;
    scene.sky = plainSky(Rgb{0.004f, 0.005f, 0.008f} * key, Rgb{0.016f, 0.021f, 0.034f} * key);
    scene.fog = 0.09f;
    scene.exposure = 1.5f;
}

static constexpr Key kTitle[] = {{rowOf(kWordComes), 0, Smooth},
                                 {rowOf(kWordComes) + 20, 1, Linear},
                                 {rowOf(kWordGoes), 1, Smooth},
                                 {rowOf(kWordGoes) + 16, 0, Linear}};

void letterPoint(const Cue &cue, const View &, Frame &frame) {
    float h = (float)frame.height;
    drawText(frame, "odraz", (float)frame.width * 0.5f, h * 0.17f, h * 0.034f, 0.085f, 5, Align::Centre,
             {0.75f, 0.72f, 0.68f}, value(track(kTitle), cue.row));
}

} // namespace odraz
