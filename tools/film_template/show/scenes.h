// The film's scenes, as film.cpp lists them.
#pragma once

#include "show/show.h"

namespace odraz {

// Each in a file of its own.
void poseStage(const SceneInput &in, Scene &scene);

} // namespace odraz
