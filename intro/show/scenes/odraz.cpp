// Scene 6. Odraz: balls of mirror, copper and glass come out of the door of light, bouncing on the beats, and
// stand in an arc around the great mirror ball, open to the camera. They dance, every other ball each beat,
// while the point of light leaps from one to the next. At the summit the arc closes to a ring, which turns
// as an upright wheel around the great ball. The balls leave before the lights go out, and one is left: it
// mirrors the word of scene 1, which is behind the camera.
#include "base/maths.h"
#include "show/door.h"
#include "show/font.h"
#include "show/materials.h"
#include "show/point_of_light.h"
#include "show/scenes.h"
#include "show/tune.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/odraz.keys"

// Materials, in the order in which they are added below
enum : uint8_t { kSilver = kHallMaterials, kClear, kRed, kPale };
static constexpr const Material *kMaterials[] = {&kMirror, &kGlass};

constexpr float kBeat = 4, kDoorSum = 5; // rows; the sum of the strips' light that adds all of the night's
constexpr int kCanon = 32;               // the row on which the mirrored voice begins in music.h

// The ring: its middle, its radius (no more, or balls would meet pillars) and its balls, from the left end of
// the arc to the right. An arc has this share of the ring's angle.
constexpr float kMiddleZ = -3.25f, kLastZ = -5, kRing = 1.38f, kSmall = 0.26f, kArc = 0.77f;
constexpr uint8_t kRingBalls[] = {kRed, kPale, kRed, kSilver, kRed, kPale, kRed, kPale, kRed, kClear};
constexpr int kBalls = sizeof kRingBalls;
constexpr float kSlot = 2 * kPi / kBalls;

// The ball by the word, as in the credits: the great ball mirrors both
static constexpr Shape kBallByWord = sphere({-3.5f, 0.7f, kLastZ + 7.3f}, 0.7f, kSilver);

// Adds a ball of the ring. far: the length of its path still ahead of it, or behind it. The ends of the arc
// follow it to the sides; from there all go straight to the door, so that none meets another. turned: the
// ring's angle; dance: how high balls leap when they are in place; lift: 1 if the ring is closed and stands
// upright, as a wheel.
static void addBall(Scene &scene, int i, float far, float turned, float beat, float dance, float lift) {
    float angle = ((float)i - 0.5f * (kBalls - 1)) * kSlot * fmadd(lift, 1 - kArc, kArc),
          side = angle < 0 ? -1.f : 1.f, around = clamp(side * angle - kPi / 2, 0.f, far / kRing);
    angle += turned - side * around, far -= around * kRing;
    float leap = beat - (float)(int)beat, away = kRing * cos(angle),
          high = leap * (1 - leap) * max(min(far, 1.2f), (i + (int)beat) & 1 ? dance : 0) +
                 lift * (kRing + 0.1f + away);
    scene.add(sphere({kRing * sin(angle), kSmall + high, kMiddleZ - away * sqrt(1 - lift * lift) - far},
                     kSmall, kRingBalls[i]));
}

void poseOdraz(const SceneInput &in, Scene &scene) {
    float row = in.row, since = row - rowOf(kWordIsFound);
    HallLight light = {kNight, {}, {}, 1, 1};
    for (float &on : light.lanterns) on = value(track(kLamps), row);
    // Let the strips play what is heard: the tune and its mirror image, the stabs, the tune again. In the
    // climax all strips chase. (0.01: a note on this very row sounds already)
    bool stabs = row >= rowOf(kRecall) && row < rowOf(kSummit);
    float dies = row - rowOf(kDoorDies), burn = 0,
          played = row + 0.01f -
                   (row < rowOf(kRecall) ? 0
                    : stabs              ? rowOf(kRecall)
                                         : rowOf(kSummit));
    if (dies < 0) playDoor(light, stabs ? kStabs : kTune, played, kBeat, 1);
    if (row < rowOf(kRecall)) playDoor(light, kMirrored, played - kCanon, kBeat, 0.5f);
    if (value(track(kChase), row) > 0)
        playDoor(light, "DEFGabcdDEFGabcd", 8.01f + row - (float)((int)row / 8 * 8), 1, 0.5f);
    balanceDoor(light, 1.1f);
    // Turn the strips off in the reverse of the order in which they came on: copper last
    for (int i = 0; i < kStrips; ++i) {
        light.strips[i] *= value(track(kStripsGo), dies - kBeat * (float)(kStrips - 1 - i));
        burn += light.strips[i] / kDoorSum;
    }
    // The point of light takes the door's place as it goes out. It writes the word, and shines in it
    PointOfLight point = pointOf(kOdraz, row);
    float word = value(track(kWord), row);
    Rgb glows = Rgb{2.2f, 0.8f, 0.2f} * word;
    // (Its light comes from a steady height, or the picture would flash when it lands.)
    light.extra = {{0.6f * point.at.x, 2, point.at.z + word},
                   lerp(kPointLight, Rgb{6, 3, 1.1f}, word) * value(track(kShines), row),
                   0.15f};
    poseHall(*in.hall, light, 0, in.camera.eye, scene);
    scene.exposure = value(track(kExposure), row);
    // Dim the night outside together with the door, or the entrance would outshine the word in front of it
    scene.sky.low = Rgb{0.004f, 0.006f, 0.01f} * min(0.3f + burn, 1.f);
    scene.sky.cover = 0;
    scene.sky.least = 0; // the darker horizon would make the sky below it negative

    scene.addAll(kMaterials);
    scene.add(metal(true, 0.26f));
    scene.add(metal(false, 0.3f));
    addPoint(scene, point, 0.05f, {});
    // The great ball comes with the others. When they leave, it rolls back a little, and stays
    float far = value(track(kApart), row), turn = value(track(kTurn), row);
    float back = row < rowOf(kSummit) ? far : (kMiddleZ - kLastZ) * smoothstep(0.f, 9.f, far);
    // At the summit all rise, and turn twice, ever faster. They fall for two beats, and land on the row on
    // which the door dies
    float free = clamp(row - rowOf(kSummit), 0.f, 32.f), fall = max(free / 8 - 3, 0.f);
    float lift = smoothstep(0.f, 12.f, free) * (1 - fall * fall);
    turn += free * free * (kPi / 256);
    scene.add(sphere({0, 0.75f + 0.95f * lift, kMiddleZ - back}, 0.75f, kSilver));
    for (int i = 0; i < kBalls && since < 0; ++i) addBall(scene, i, far, turn, row / kBeat, 1 - fall, lift);
    if (since > 0) scene.add(kBallByWord);
    if (word > 0)
        addText(scene, "odraz", {-2.35f, 0.11f, kLastZ + 6.1f}, 0.09f, since - kBeat, scene.add(lamp(glows)));
}

} // namespace odraz
