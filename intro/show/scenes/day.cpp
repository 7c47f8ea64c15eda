// Scene 5. A day in the hall: dawn, noon, dusk; lanterns, night, the door of light.
#include "show/scenes.h"

namespace odraz {

using enum Interpolation;

// The hour jumps where the shot does
static constexpr Key kHour[] = {{0, 0.3f, Linear},   {64, 1.2f, Linear},  {64, 1.99f, Linear},
                                {128, 4.3f, Linear}, {160, 5.3f, Linear}, {160, 5.9f, Linear},
                                {192, 6.6f, Linear}, {200, 7, Linear}};
// How much of the sun is drawn with hard edges: at dawn its light is soft
static constexpr Key kSun[] = {{-16, 0, Smooth}, {40, 1, Linear}};
// A lantern's light, from the row on which it comes up, or dies
static constexpr Key kComesUp[] = {{0, 0, Smooth}, {8, 0.8f, Linear}};
static constexpr Key kGoesOut[] = {{0, 1, Smooth}, {8, 0, Linear}};
// From the door on, as they stand; the last to come up is the last to die
static constexpr float kUp[kLanterns] = {rowOf(kLamp3), rowOf(kLamp2), rowOf(kLamp1)},
                       kOut[kLanterns] = {rowOf(kLamp3Dies), rowOf(kLamp2Dies), rowOf(kLamp1Dies)};
static constexpr Key kExposure[] = {{0, 3, Smooth},      {56, 1.4f, Linear}, {130, 1.35f, Smooth},
                                    {196, 2.1f, Smooth}, {208, 20, Linear},  {224, 20, Smooth},
                                    {228, 3, Smooth},    {240, 2.1f, Linear}};

void poseDay(const Cue &cue, Scene &scene) {
    HallLight light = {};
    light.hour = value(track(kHour), cue.row);
    for (int i = 0; i < kLanterns; ++i)
        light.lanterns[i] =
            value(track(kComesUp), cue.row - kUp[i]) * value(track(kGoesOut), cue.row - kOut[i]);
    light.sun = value(track(kSun), cue.row);
    // The strips rise in turn. Later something passes behind them, and they go out and return, one a beat
    // again
    static constexpr Key kRise[] = {
        {0, 0, Smooth}, {4, 1, Linear}, {32, 1, Smooth}, {34, 0.05f, Smooth}, {36, 1, Linear}};
    static constexpr float kRows[kStrips] = {rowOf(kStrip1), rowOf(kStrip2), rowOf(kStrip3), rowOf(kStrip4),
                                             rowOf(kStrip5), rowOf(kStrip6), rowOf(kStrip7), rowOf(kStrip8)};
    for (int i = 0; i < kStrips; ++i) light.strips[i] = value(track(kRise), cue.row - kRows[i]);
    poseHall(*cue.hall, light, 0, cue.camera.eye, scene);
    scene.exposure = value(track(kExposure), cue.row);
}

} // namespace odraz
