// Scenes of which one thing grows, to measure by how much a picture's work grows with it. Both are looked at
// by kPeerCameraA.
#pragma once

#include "trace/scene/scene.h"

namespace odraz {

// So many balls strewn above a floor, every third a mirror, two lights: they are the smaller the more there
// are, and cover about as much of the picture.
void poseBalls(Scene &scene, int count);

// Peer scene A with so many lights, 1 .. kMaxLights; 2 are its own.
void poseLights(Scene &scene, int count);

} // namespace odraz
