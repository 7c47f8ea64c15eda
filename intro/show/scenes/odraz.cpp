// Scene 6. Odraz: out of the door of light come mirrors, copper and glass, two a beat, their shadows before
// them; everything reflects everything. They go back before the lights die, and one is left: it mirrors the
// word of scene 1, which stands behind the camera.
#include "base/maths.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/scenes.h"
#include "show/score.h"
#include "show/tune.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/odraz.keys"

// In the order in which they are added below
enum : uint8_t { kSilver = kHallMaterials, kClear, kRed, kPale };
static constexpr const Material *kMaterials[] = {&kMirror, &kGlass};

constexpr float kGlow = 2.8f; // all strips together; a tone adds to one of them
constexpr int kCanon = 8;     // the beat at which the mirrored voice begins in music.h

// Three lanes: the ball that stays with three behind it, and six on either side. The first to come stands in
// front and goes last, so that no ball passes another.
constexpr int kBeat = 4, kRows = 6, kBehind = 3;
constexpr float kStays = -5, kHidden = -11.4f; // in z, behind the door
constexpr uint8_t kSides[2][kRows] = {{kRed, kSilver, kPale, kRed, kPale, kRed},
                                      {kClear, kPale, kRed, kPale, kRed, kPale}};

// Adds a ball of a lane, rolled by the way that it has come.
static void addBall(Scene &scene, float row, float x, float z, float radius, float comes, float goes,
                    int material) {
    float left = value(track(kLeft), row - comes), back = value(track(kBack), row - goes);
    float way = 1 - left * left - back * back;
    if (way <= 0) return;
    float at = kHidden + (z - kHidden) * way, turn = at / radius;
    Shape *s = scene.add(sphere({x, radius, at}, radius, material));
    s->frame = {{1, 0, 0}, {0, cos(turn), sin(turn)}, {0, -sin(turn), cos(turn)}};
}

// The strip that a tone strikes: D to d, and the octave of those below D.
static constexpr int stripOf(char tone) { return stepOf(tone) + (stepOf(tone) < 0 ? 7 : 0); }
static_assert(stripOf('D') == 0 && stripOf('A') == stripOf('a') && stripOf('C') == 6 &&
              stripOf('d') == kStrips - 1);

void poseOdraz(const SceneInput &in, Scene &scene) {
    HallLight light = {kNight, {}, {}, 1, 1};
    light.lanterns[1] = light.lanterns[2] = value(track(kOuter), in.row);
    light.lanterns[0] = max(light.lanterns[1], value(track(kLast), in.row));
    // The strips are the scale: each tone of the tune strikes one, as they rose to it, and from the fifth bar
    // its mirror image does so half as hard. Together they burn evenly: the colour changes, not the level
    float all = kGlow, burn = 0;
    auto strike = [&](char tone, float struck) {
        if (tone != '-') light.strips[stripOf(tone)] += struck, all += struck;
    };
    for (int beat = 0; beat < 32; ++beat) {
        float struck = value(track(kStruck), in.row - (float)(kBeat * beat));
        strike(kTune[beat], struck);
        if (beat >= kAnswer) strike(kMirrored[beat - kCanon], struck * 0.5f);
    }
    // They go out as they came, copper first, and blue is left
    float each = 7 / all;
    for (int i = 0; i < kStrips; ++i) {
        light.strips[i] =
            (light.strips[i] + kGlow / kStrips) * each * value(track(kStripsGo), in.row - (float)(kBeat * i));
        burn += light.strips[i] / kStrips;
    }
    // The word glows up when it is large enough to be read, and lights the hall
    float since = in.row - rowOf(kWordIsFound);
    Rgb glows = Rgb{2.6f, 0.9f, 0.27f} * saturate(0.1f * since - 1.3f);
    light.guest = {{0, 1.3f, kStays + 5.5f}, glows * Rgb{0.8f, 0.95f, 1.2f}, 0.3f};
    poseHall(*in.hall, light, 0, in.camera.eye, scene);
    scene.exposure = value(track(kExposure), in.row);
    // The night outside dims with the door, or the entrance would outshine the word before it
    scene.sky.low = Rgb{0.004f, 0.006f, 0.01f} * min(0.3f + burn, 1.f);
    scene.sky.cover = 0;
    // As the door dies, a cold light comes up behind it: the last ball keeps its outline and its shadow
    if (float cold = 0.7f - burn; cold > 0)
        scene.add(Light{{0, 2.7f, -9.03f}, Rgb{1.1f, 1.9f, 3.3f} * cold, 0.3f});

    scene.addAll(kMaterials);
    scene.add(pearl(true, 0.26f));
    scene.add(pearl(false, 0.25f));
    addBall(scene, in.row, 0, kStays, 0.75f, rowOf(kBall1) - 2, 999, kSilver);
    for (int i = 0; i < kRows; ++i) {
        float z = kStays + 2 - (float)i, radius = i & 1 ? 0.3f : 0.4f, aside = i & 1 ? 1.45f : 1.2f;
        float comes = rowOf(kBall2) + (float)(kBeat * (i < 4 ? i : i + 6)),
              goes = rowOf(kBall1Leaves) - (float)(kBeat * i);
        for (int side = 0; side < 2; ++side)
            addBall(scene, in.row, side ? aside : -aside, z - 0.4f * (float)side, radius, comes, goes,
                    kSides[side][i]);
    }
    for (int i = 0; i < kBehind; ++i)
        addBall(scene, in.row, 0, kStays - 1.35f - 1.05f * (float)i, 0.45f,
                rowOf(kBall2) + (float)(kBeat * (8 + 2 * i)),
                rowOf(kBall5Leaves) + (float)(2 * kBeat * (kBehind - 1 - i)), i & 1 ? kPale : kRed);
    if (since > 0) scene.add(sphere({-3.5f, 0.7f, kStays + 7.3f}, 0.7f, kSilver));
    if (maxComponent(glows) > 0)
        standText(scene, "odraz", {-2.35f, 0.11f, kStays + 6.1f}, 0.09f, 8 * since, scene.add(lamp(glows)));
}

} // namespace odraz
