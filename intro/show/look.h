// The look of the film's camera, in every picture.
#pragma once

#include "trace/picture/development.h"

namespace odraz {

inline constexpr CameraLook kFilmLook = {.glare = 0.06f, .vignette = 0.25f, .grain = 48};

} // namespace odraz
