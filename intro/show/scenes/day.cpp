// Scene 5. A day in the hall: dawn, noon, dusk; lanterns, night, the door of light.
#include "show/show.h"

namespace odraz {

using enum Interpolation;

static constexpr Key kHour[] = {{0, 0, Linear}, {20, 0.2f, Linear}, {168, 6, Linear}, {200, 7, Linear}};
static constexpr Key kLantern1[] = {{148, 0, Smooth}, {156, 1, Linear}, {224, 1, Smooth}, {244, 0, Linear}};
static constexpr Key kLantern2[] = {
    {164, 0, Smooth}, {172, 0.8f, Linear}, {220, 0.8f, Smooth}, {240, 0, Linear}};
static constexpr Key kLantern3[] = {
    {180, 0, Smooth}, {188, 0.6f, Linear}, {216, 0.6f, Smooth}, {236, 0, Linear}};
static constexpr Key kExposure[] = {
    {0, 2.3f, Smooth}, {60, 2.0f, Linear}, {130, 2.0f, Smooth}, {180, 2.1f, Linear}};

void poseDay(const Cue &cue, Scene &scene) {
    HallLight light = {};
    light.hour = value(track(kHour), cue.row);
    light.lanterns[2] = value(track(kLantern1), cue.row);
    light.lanterns[1] = value(track(kLantern2), cue.row);
    light.lanterns[0] = value(track(kLantern3), cue.row);
    light.sun = 1;
    // The strips rise in turn, one every half bar
    static constexpr Key kRise[] = {{0, 0, Smooth}, {7, 1, Linear}};
    for (int i = 0; i < kStrips; ++i) light.strips[i] = value(track(kRise), cue.row - 226 - 5 * i);
    poseHall(*cue.hall, light, 0, cue.camera.eye, scene);
    scene.exposure = value(track(kExposure), cue.row);
}

} // namespace odraz
