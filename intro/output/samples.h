// The music in 16 bits, for devices and files.
#pragma once

#include "intro.h"

namespace odraz {

// Rounds a block to samples of 16 bits, with dither. The dither depends only on the block's number, so that a
// device and a file get the same samples.
void quantize(const float block[2 * kSoundBlock], int number, int16_t samples[2 * kSoundBlock]);

} // namespace odraz
