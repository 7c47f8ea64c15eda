// Writing the film's music instead of playing it.
#pragma once

#include "options.h"

namespace odraz {

// Writes the music of the interval that the options name as a WAV: 48 kHz, two channels of 16 bits, dithered;
// exit status. What is written depends on the time alone, so parts of it join. `stdoutClosed`: standard
// output was closed at the start.
int writeWav(const Options &options, bool stdoutClosed);

} // namespace odraz
