// Scene 6. Odraz: the balls of the table roll into the lit hall; everything reflects everything. Then the
// light falls to one lantern, and one ball is left.
#include "base/maths.h"
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

using enum Interpolation;

static constexpr Key kStripsGo[] = {{0, 0.8f, Smooth},
                                    {20, 0.35f, Linear},
                                    {rowOf(kDoorDies), 0.35f, Smooth},
                                    {rowOf(kDoorDies) + 28, 0, Linear}};
static constexpr Key kOuter[] = {{rowOf(kLampLights), 0, Smooth},
                                 {rowOf(kLampLights) + 20, 0.65f, Linear},
                                 {rowOf(kOuterLampsDie), 0.65f, Smooth},
                                 {rowOf(kOuterLampsDie) + 28, 0, Linear}};
static constexpr Key kMiddle[] = {{0, 0, Smooth}, {16, 1, Linear}};
static constexpr Key kIn[] = {{0, 14, Smooth}, {56, 0, Linear}};
static constexpr Key kOut[] = {{0, 0, Smooth}, {44, 14, Linear}};

enum { kSilver = kHallMaterials, kClear, kRed, kGround };
static constexpr const Material *kMaterials[] = {&kMirror, &kGlass, &kCopper, &kGranite};

// They come by the entrance, each in a lane of its own or behind another that goes after it; two lie in the
// aisles.
static constexpr struct {
    float x, z, radius, comes, goes;
    int material;
} kBalls[] = {
    {0, 0.4f, 0.75f, rowOf(kBall2), 999, kSilver},
    {-1.25f, -2.2f, 0.40f, rowOf(kBall3), rowOf(kBall3Leaves), kClear},
    {1.25f, -1.5f, 0.42f, rowOf(kBall1), rowOf(kBall1Leaves), kSilver},
    {-1.27f, 2.3f, 0.34f, rowOf(kBall5), rowOf(kBall5Leaves), kRed},
    {1.27f, 1.7f, 0.36f, rowOf(kBall4), rowOf(kBall4Leaves), kClear},
    {-3.4f, 0.2f, 0.55f, -99, 999, kSilver},
    {3.4f, 0.9f, 0.5f, -99, 999, kSilver},
    {0, -4.3f, 0.6f, -9, 999, kRed},
};

void poseOdraz(const Cue &cue, Scene &scene) {
    HallLight light = {kHours - 1, {}, {}, 1};
    light.lanterns[0] = value(track(kOuter), cue.row);
    light.lanterns[1] = value(track(kMiddle), cue.row);
    light.lanterns[2] = value(track(kOuter), cue.row + 8);
    for (float &strip : light.strips) strip = value(track(kStripsGo), cue.row);
    poseHall(*cue.hall, light, 0, cue.camera.eye, scene);
    scene.exposure = 2.1f;

    scene.addAll(kMaterials);
    scene.add(box({0, -0.1f, 14}, {5, 0.1f, 5}, kGround));
    for (const auto &b : kBalls) {
        float way = value(track(kIn), cue.row - b.comes) + value(track(kOut), cue.row - b.goes),
              turn = way / b.radius;
        Shape *s = scene.add(sphere({b.x, b.radius, b.z + way}, b.radius, b.material));
        s->frame = {{1, 0, 0}, {0, cos(turn), sin(turn)}, {0, -sin(turn), cos(turn)}};
    }
}

} // namespace odraz
