#include "show/point_of_light.h"

#include "base/maths.h"
#include "show/materials.h"
#include "show/show.h"
#include "timeline/keys.h"

namespace odraz {

#include "show/point_of_light.keys"

// The paths of the point of light, by scene. The file of keys says what a path's channels mean here.
static KEYED CameraPath kPoints[kSceneCount] = { // rows in the enum's order
    [kPoint] = path(kPointWakes),    [kTable] = path(kPointOfTable), [kFlake] = path(kPointOfFlake),
    [kPatches] = path(kPointOfWire), [kHall] = path(kPointOfHall),   [kOdraz] = path(kPointOfBalls),
    [kCredits] = path(kPointGoes)};

constexpr float kRadiance = 80; // its ball's, in units of kPointLight

PointOfLight pointOf(int scene, float storyRow) {
    CameraKey key = pose(kPoints[scene], storyRow);
    float angle = key.target.y * (2 * kPi), leap = storyRow / 4 - (float)(int)(storyRow / 4);
    Vec3 moved = {key.target.x * sin(angle), key.fov * (leap - leap * leap) * 4, key.target.x * cos(angle)};
    return {key.eye + moved, max(key.roll, 0.f)};
}

PointOfLight pointAt(double seconds) {
    Moment m = momentAt(kFilm, seconds * kRowsPerSecond);
    return pointOf(m.shot->scene, m.storyRow);
}

void addPoint(Scene &scene, const PointOfLight &point, float radius, const Rgb &intensity) {
    if (point.shine <= 0) return;
    scene.add(sphere(point.at, radius, scene.add(lamp(kPointLight * (kRadiance * point.shine)))));
    if (maxComponent(intensity) > 0) scene.add(Light{point.at, intensity * point.shine, 2 * radius});
}

} // namespace odraz
