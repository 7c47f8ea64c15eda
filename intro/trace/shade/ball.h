// The form factor of a ball: the share of a surface point's cosine-weighted hemisphere that it covers.
#pragma once

#include "base/vec3.h"

namespace odraz {

// `cosine` is between the normal and the direction to the ball's centre; `sine2` = (radius / distance)^2. The
// part below the horizon does not count. The error is below 1e-6 for 0 <= sine2 < 1, |cosine| <= 1; points
// inside the ball count as just outside. Snyder, "Area Light Sources for Real-Time Graphics", 1996.
Float8 ballFormFactor(Float8 cosine, Float8 sine2);

} // namespace odraz
