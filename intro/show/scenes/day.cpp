// Scene 5. A day in the hall: dawn, noon, dusk, lanterns; then the light of scene 1 lights the door.
#include "show/materials.h"
#include "show/scenes.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/hall.keys"

// The rows on which the lanterns are turned on and off, beginning with the one nearest the door
static constexpr float kOn[kLanterns] = {rowOf(kLamp3), rowOf(kLamp2), rowOf(kLamp1)},
                       kOff[kLanterns] = {rowOf(kLamp3Dies), rowOf(kLamp2Dies), rowOf(kLamp1Dies)};

void poseDay(const SceneInput &in, Scene &scene) {
    HallLight light = {};
    light.hour = value(track(kHour), in.row);
    for (int i = 0; i < kLanterns; ++i)
        light.lanterns[i] = value(track(kTurnOn), in.row - kOn[i]) * value(track(kTurnOff), in.row - kOff[i]);
    light.sun = value(track(kSun), in.row);
    static constexpr float kRows[kStrips] = {rowOf(kStrip1), rowOf(kStrip2), rowOf(kStrip3), rowOf(kStrip4),
                                             rowOf(kStrip5), rowOf(kStrip6), rowOf(kStrip7), rowOf(kStrip8)};
    for (int i = 0; i < kStrips; ++i) light.strips[i] = value(track(kRise), in.row - kRows[i]);
    // The light of scene 1 flies from the entrance to the first strip
    float since = in.row - rowOf(kLightReturns),
          shines = value(track(kRise), fmadd(since, 0.5f, 3.5f)) *
                   value(track(kTurnOff), 0.65f * (in.row - rowOf(kStrip1)));
    Vec3 point = {value(track(kFlightX), since), 1.4f, value(track(kFlightZ), since)};
    light.extra = {point, Rgb{2.6f, 2.0f, 1.35f} * shines, 0.06f};
    poseHall(*in.hall, light, 0, in.camera.eye, scene);
    if (shines > 0) scene.add(sphere(point, 0.06f, scene.add(lamp(Rgb{200, 170, 120} * shines))));
    scene.exposure = value(track(kExposure), in.row);
}

} // namespace odraz
