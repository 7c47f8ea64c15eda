// Writes the film's music instead of playing it.
#pragma once

#include "options.h"

namespace odraz {

// Writes the music between --from and --to as a WAV file: 48 kHz, two channels of 16 bits, dithered. Returns
// an exit status. A sample depends only on its time, so parts that are written separately join without a gap.
// `stdoutClosed`: standard output was closed at the start.
int writeWav(const Options &options, bool stdoutClosed);

} // namespace odraz
