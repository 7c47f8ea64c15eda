// Scene 6. Odraz: the balls of the table roll into the lit hall; everything reflects everything. Then the
// light falls to one lantern, and one ball is left.
#include "base/maths.h"
#include "show/materials.h"
#include "show/show.h"

namespace odraz {

using enum Interpolation;

static constexpr Key kStripsGo[] = {
    {0, 0.8f, Smooth}, {20, 0.35f, Linear}, {96, 0.35f, Smooth}, {124, 0, Linear}};
static constexpr Key kOuter[] = {{4, 0, Smooth}, {24, 0.65f, Linear}, {100, 0.65f, Smooth}, {128, 0, Linear}};
static constexpr Key kMiddle[] = {{0, 0, Smooth}, {16, 1, Linear}};
static constexpr Key kIn[] = {{0, 14, Smooth}, {56, 0, Linear}};
static constexpr Key kOut[] = {{0, 0, Smooth}, {44, 14, Linear}};

void poseOdraz(const Cue &cue, Scene &scene) {
    HallLight light = {kHours - 1, {}, {}, 1};
    light.lanterns[0] = value(track(kOuter), cue.row);
    light.lanterns[1] = value(track(kMiddle), cue.row);
    light.lanterns[2] = value(track(kOuter), cue.row + 8);
    for (float &strip : light.strips) strip = value(track(kStripsGo), cue.row);
    poseHall(*cue.hall, light, 0, cue.camera.eye, scene);
    scene.exposure = 2.1f;

    int silver = scene.add(mirror()), clear = scene.add(glass()), red = scene.add(copper());
    int ground = scene.add(granite());
    // They come by the entrance, each in a lane of its own or behind another that goes after it; two lie in
    // the aisles
    scene.add(box({0, -0.1f, 14}, {5, 0.1f, 5}, ground));
    struct Ball {
        float x, z, radius, comes, goes;
        int material;
    } const balls[] = {
        {0, 0.4f, 0.75f, 2, 999, silver},      {-1.25f, -2.2f, 0.40f, 8, 112, clear},
        {1.25f, -1.5f, 0.42f, 0, 116, silver}, {-1.27f, 2.3f, 0.34f, 22, 98, red},
        {1.27f, 1.7f, 0.36f, 16, 102, clear},  {-3.4f, 0.2f, 0.55f, -99, 999, silver},
        {3.4f, 0.9f, 0.5f, -99, 999, silver},  {0, -4.3f, 0.6f, -9, 999, red},
    };
    for (const Ball &b : balls) {
        float way = value(track(kIn), cue.row - b.comes) + value(track(kOut), cue.row - b.goes),
              turn = way / b.radius;
        Shape *s = scene.add(sphere({b.x, b.radius, b.z + way}, b.radius, b.material));
        s->frame = {{1, 0, 0}, {0, cos(turn), sin(turn)}, {0, -sin(turn), cos(turn)}};
    }
}

} // namespace odraz
