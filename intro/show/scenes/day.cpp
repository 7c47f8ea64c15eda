// Scene 5. The hall by day and by night: noon, sunset, lanterns, beside the mirror ball. Then the point of
// light comes back and wakes the strips of the door, which play.
#include "base/maths.h"
#include "show/door.h"
#include "show/materials.h"
#include "show/point_of_light.h"
#include "show/scenes.h"
#include "show/tune.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/scenes/hall.keys"

constexpr float kBeat = 4;

static void addBall(Scene &scene, float x, float z) {
    scene.add(sphere({x, 0.75f, z}, 0.75f, scene.add(kMirror)));
}

void addGuest(Scene &scene, float rows) {
    float z = max(rows, 0.f) * 0.0342f;
    z *= z;
    addBall(scene, 1.2f - 2.2f * z / (z + 0.5f), z);
}

void poseDay(const SceneInput &in, Scene &scene) {
    HallLight light = {};
    light.hour = value(track(kHour), in.row);
    light.sun = 1;
    // The lanterns wake a beat apart, the nearest to the entrance first, and die in the mirrored order
    for (int i = 0; i < kLanterns; ++i)
        light.lanterns[i] = value(track(kWakes), in.row - rowOf(kLamp3) + kBeat * (float)i) -
                            value(track(kWakes), in.row - rowOf(kLamp3Dies) - kBeat * (float)i);
    if (in.row >= rowOf(kStrip1)) light.door = 1;
    // The strips wake a beat apart, then play; on the last beat they are dark
    float since = in.row - rowOf(kStripsPlay);
    if (since < 0)
        for (int i = 0; i < kStrips; ++i)
            light.strips[i] = value(track(kWakes), in.row - rowOf(kStrip1) - kBeat * (float)i);
    else if (in.row < rowOf(kDoorStops)) {
        playDoor(light, kDoorTune, since, 2, 1);
        balanceDoor(light, 2.0f);
    }
    PointOfLight point = pointOf(kHall, in.row);
    // (It lights nothing while it is at most half as bright as it can be)
    light.extra = {point.at, kPointLight * max(fmadd(point.shine, 2.f, -1.f), 0.f), 0.06f};
    poseHall(*in.hall, light, 0, in.camera.eye, scene);
    addPoint(scene, point, min(0.06f, 0.02f * length(point.at - in.camera.eye)), {});
    // The ball comes by day, and waits. It rolls to the copper strip, and is gone when the strips play
    float rolled = smoothstep(rowOf(kStrip1), rowOf(kStripsPlay), in.row);
    if (rolled == 0)
        addGuest(scene, 60 - in.row);
    else if (rolled < 1)
        addBall(scene, lerp(1.2f, -1.3f, rolled), -8.25f * rolled);
    scene.exposure = value(track(kExposure), in.row);
}

} // namespace odraz
