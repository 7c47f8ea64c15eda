// Music as devices and files want it.
#pragma once

#include "intro.h"

namespace odraz {

// A block as samples of 16 bits, dithered by what its number says, so that all who make them make the same.
void quantize(const float block[2 * kSoundBlock], int number, int16_t samples[2 * kSoundBlock]);

} // namespace odraz
