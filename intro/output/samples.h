// Music in the form that devices and files need.
#pragma once

#include "intro.h"

namespace odraz {

// Turns a block into samples of 16 bits. The dither depends on the block's number alone, so a device and a
// file get the same samples.
void quantize(const float block[2 * kSoundBlock], int number, int16_t samples[2 * kSoundBlock]);

} // namespace odraz
