// Scenes in which one thing grows, to measure how a picture's work grows with it. kPeerCameraA shows both.
#pragma once

#include "trace/scene/scene.h"

namespace odraz::measure {

// `count` balls strewn above a floor, every third a mirror, and two lights. More balls are smaller, so that
// they cover about the same part of the picture.
void poseBalls(Scene &scene, int count);

// Peer scene A with 1 .. kMaxLights lights; A itself has 2.
void poseLights(Scene &scene, int count);

} // namespace odraz::measure
