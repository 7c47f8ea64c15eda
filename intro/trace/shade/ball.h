// The form factor of a ball: what share of a surface point's cosine-weighted hemisphere it covers.
#pragma once

#include "base/vec3.h"

namespace odraz {

// For a ball whose middle stands in a direction of the given cosine to the normal; `sine2` = (radius /
// distance)^2. The part under the horizon is left out. Within 1e-6 for 0 <= sine2 < 1, |cosine| <= 1; a point
// inside counts as just outside. Source: Snyder, "Area Light Sources for Real-Time Graphics", 1996.
Float8 ballFormFactor(Float8 cosine, Float8 sine2);

} // namespace odraz
