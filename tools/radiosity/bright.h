// How bright light is, as one number: its luminance (Rec. 709).
#pragma once

#include "base/vec3.h"

namespace odraz {

inline float bright(const Rgb &c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

} // namespace odraz
