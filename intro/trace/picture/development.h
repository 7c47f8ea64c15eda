// From linear radiance to what is shown: film curve, sRGB, eight bits.
#pragma once

#include "base/float8.h"
#include "base/parallel.h"
#include "trace/picture/frame.h"

namespace odraz {

// The film curve: 0 -> 0, rising, infinity -> 1; 0.18 -> 0.26, 1 -> 0.78. x >= 0, NaN gives 0.
Float8 filmic(Float8 x);

// Encodes [0, 1] after IEC 61966-2-1.
Float8 encodeSrgb(Float8 x);

// Fills frame.rgba: radiance * exposure through the film curve to sRGB. Half a bit of fixed noise hides the
// steps.
void develop(Frame &frame, Workers &workers, float exposure);

} // namespace odraz
