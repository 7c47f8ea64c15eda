// The two scenes for the comparison with POV-Ray.
//
//   A  ten balls on a checker with noise, two lights, three mirrors, glass of constant reflectance
//   B  the "balls" sphereflake of Haines' Standard Procedural Databases, level 4: 7,381 balls and a plane
//
// POV-Ray's lights do not fade with distance; odraz's lights do. Both are equally bright in the middle of the
// scene.
#pragma once

#include "timeline/camera.h"
#include "trace/scene/scene.h"

#include <string>

namespace odraz::measure {

void posePeerA(Scene &scene);
void posePeerB(Scene &scene, int level = 4);
inline constexpr CameraKey kPeerCameraA = {0, {0, 2.6f, 9}, {0, 1.2f, 0}, 0, 29.3953f};
inline constexpr CameraKey kPeerCameraB = {0, {2.1f, 1.7f, -1.3f}, {0, 0, 0}, 0, 42.9957f};

// Scene A (or B, if `b`) in the language of POV-Ray 3.7. The noise is POV-Ray's own, so a picture is compared
// with a reference by the same tracer, never across tracers.
std::string povOf(bool b);

// A field of balls 2 to 8 pixels wide at 1280x720, some of which an adaptive tracer may miss.
void poseField(Scene &scene);
inline constexpr CameraKey kFieldCamera = {0, {0, 0, 10}, {0, 0, 0}, 0, 40};

} // namespace odraz::measure
