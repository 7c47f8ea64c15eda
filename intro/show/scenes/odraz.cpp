// Scene 6. Odraz: balls of mirror, copper and glass roll out of the door of light, two a beat, behind their
// shadows; everything reflects everything. They go back before the lights go out, and one is left: it mirrors
// the word of scene 1, which is behind the camera.
#include "base/maths.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/scenes.h"
#include "show/score.h"
#include "show/tune.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/odraz.keys"

// Materials, in the order in which they are added below
enum : uint8_t { kSilver = kHallMaterials, kClear, kRed, kPale };
static constexpr const Material *kMaterials[] = {&kMirror, &kGlass};

constexpr float kGlow = 2.8f; // the strips' total light; a tone adds to one of them
constexpr int kCanon = 8;     // the beat at which the mirrored voice begins in music.h

// Balls in three lanes: the one that stays, with three behind it, and six on either side. A lane's front ball
// comes first and goes last, so that no ball passes another.
constexpr int kBeat = 4, kRows = 6, kBehind = 3;
constexpr float kFrontZ = -5, kHiddenZ = -11.4f; // z of the front ball when it stops; z behind the door
constexpr uint8_t kSides[2][kRows] = {{kRed, kSilver, kPale, kRed, kPale, kRed},
                                      {kClear, kPale, kRed, kPale, kRed, kPale}};

// The rows on which a ball comes out of the door, and goes back.
struct Visit {
    float comes, goes;
};

// Adds a ball of a lane, rolled by the length of its path. x, z: where it stops.
static void addBall(Scene &scene, float row, float x, float z, float radius, Visit visit, int material) {
    float ahead = value(track(kAhead), row - visit.comes), back = value(track(kBack), row - visit.goes);
    float share = 1 - ahead * ahead - back * back;
    if (share <= 0) return;
    float at = kHiddenZ + (z - kHiddenZ) * share, turn = at / radius;
    Shape *s = scene.add(sphere({x, radius, at}, radius, material));
    s->frame = {{1, 0, 0}, {0, cos(turn), sin(turn)}, {0, -sin(turn), cos(turn)}};
}

// Returns the strip that a tone strikes: D to d; tones below D strike the strip an octave higher.
static constexpr int stripOf(char tone) { return stepOf(tone) + (stepOf(tone) < 0 ? 7 : 0); }
static_assert(stripOf('D') == 0 && stripOf('A') == stripOf('a') && stripOf('C') == 6 &&
              stripOf('d') == kStrips - 1);

void poseOdraz(const SceneInput &in, Scene &scene) {
    HallLight light = {kNight, {}, {}, 1, 1};
    light.lanterns[1] = light.lanterns[2] = value(track(kOuter), in.row);
    light.lanterns[0] = max(light.lanterns[1], value(track(kLast), in.row));
    // Let each tone of the tune strike its strip, and from the fifth bar the tones of its mirror image, half
    // as hard. The sum is constant: the colour of the light changes, not its level
    float all = kGlow, burn = 0;
    auto strike = [&](char tone, float struck) {
        if (tone != '-') light.strips[stripOf(tone)] += struck, all += struck;
    };
    for (int beat = 0; beat < 32; ++beat) {
        float struck = value(track(kStruck), in.row - (float)(kBeat * beat));
        strike(kTune[beat], struck);
        if (beat >= kAnswer) strike(kMirrored[beat - kCanon], struck * 0.5f);
    }
    // Turn the strips off in the order in which they came on: copper first, blue last
    float scale = 7 / all;
    for (int i = 0; i < kStrips; ++i) {
        light.strips[i] = (light.strips[i] + kGlow / kStrips) * scale *
                          value(track(kStripsGo), in.row - (float)(kBeat * i));
        burn += light.strips[i] / kStrips;
    }
    // Light the word when it is large enough to be read: it lights the hall, too
    float since = in.row - rowOf(kWordIsFound);
    Rgb glows = Rgb{2.6f, 0.9f, 0.27f} * saturate(0.1f * since - 1.3f);
    light.extra = {{0, 1.3f, kFrontZ + 5.5f}, glows * Rgb{0.8f, 0.95f, 1.2f}, 0.3f};
    poseHall(*in.hall, light, 0, in.camera.eye, scene);
    scene.exposure = value(track(kExposure), in.row);
    // Dim the night outside together with the door, or the entrance would outshine the word in front of it
    scene.sky.low = Rgb{0.004f, 0.006f, 0.01f} * min(0.3f + burn, 1.f);
    scene.sky.cover = 0;
    // As the door goes out, fade in a cold light behind it: the last ball keeps its outline and its shadow
    if (float cold = 0.7f - burn; cold > 0)
        scene.add(Light{{0, 2.7f, -9.03f}, Rgb{1.1f, 1.9f, 3.3f} * cold, 0.3f});

    scene.addAll(kMaterials);
    scene.add(pearl(true, 0.26f));
    scene.add(pearl(false, 0.25f));
    addBall(scene, in.row, 0, kFrontZ, 0.75f, {rowOf(kBall1) - 2, 999}, kSilver);
    for (int i = 0; i < kRows; ++i) {
        float z = kFrontZ + 2 - (float)i, radius = i & 1 ? 0.3f : 0.4f, x = i & 1 ? 1.45f : 1.2f;
        float comes = rowOf(kBall2) + (float)(kBeat * (i < 4 ? i : i + 6)),
              goes = rowOf(kBall1Leaves) - (float)(kBeat * i);
        for (int side = 0; side < 2; ++side)
            addBall(scene, in.row, side ? x : -x, z - 0.4f * (float)side, radius, {comes, goes},
                    kSides[side][i]);
    }
    for (int i = 0; i < kBehind; ++i)
        addBall(scene, in.row, 0, kFrontZ - 1.35f - 1.05f * (float)i, 0.45f,
                {rowOf(kBall2) + (float)(kBeat * (8 + 2 * i)),
                 rowOf(kBall5Leaves) + (float)(2 * kBeat * (kBehind - 1 - i))},
                i & 1 ? kPale : kRed);
    if (since > 0) scene.add(sphere({-3.5f, 0.7f, kFrontZ + 7.3f}, 0.7f, kSilver));
    if (maxComponent(glows) > 0)
        addText(scene, "odraz", {-2.35f, 0.11f, kFrontZ + 6.1f}, 0.09f, 8 * since, scene.add(lamp(glows)));
}

} // namespace odraz
