// Writes the film's music instead of playing it.
#pragma once

#include "options.h"

namespace odraz {

// Writes the music of the interval that the options select as a WAV file: 48 kHz, two channels of 16 bits,
// dithered. Returns an exit status. A sample depends on its time alone, so separately written parts join.
// `stdoutClosed`: standard output was closed at the start.
int writeWav(const Options &options, bool stdoutClosed);

} // namespace odraz
