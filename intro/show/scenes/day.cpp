// Scene 5. A day in the hall: dawn, noon, dusk; lanterns, night, the door of light.
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/hall.keys"

// From the door on, as they stand; the last to come up is the last to die
static constexpr float kUp[kLanterns] = {rowOf(kLamp3), rowOf(kLamp2), rowOf(kLamp1)},
                       kOut[kLanterns] = {rowOf(kLamp3Dies), rowOf(kLamp2Dies), rowOf(kLamp1Dies)};

void poseDay(const SceneInput &in, Scene &scene) {
    HallLight light = {};
    light.hour = value(track(kHour), in.row);
    for (int i = 0; i < kLanterns; ++i)
        light.lanterns[i] =
            value(track(kComesUp), in.row - kUp[i]) * value(track(kGoesOut), in.row - kOut[i]);
    light.sun = value(track(kSun), in.row);
    static constexpr float kRows[kStrips] = {rowOf(kStrip1), rowOf(kStrip2), rowOf(kStrip3), rowOf(kStrip4),
                                             rowOf(kStrip5), rowOf(kStrip6), rowOf(kStrip7), rowOf(kStrip8)};
    for (int i = 0; i < kStrips; ++i) light.strips[i] = value(track(kRise), in.row - kRows[i]);
    poseHall(*in.hall, light, 0, in.camera.eye, scene);
    scene.exposure = value(track(kExposure), in.row);
}

} // namespace odraz
