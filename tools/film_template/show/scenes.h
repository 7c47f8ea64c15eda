// The film's scenes, which film.cpp lists.
#pragma once

#include "show/show.h"

namespace odraz {

// Each scene has its own file.
void poseStage(const SceneInput &in, Scene &scene);

} // namespace odraz
