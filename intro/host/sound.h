// Where sound goes: 48,000 frames a second of two 16-bit samples, left and right.
#pragma once

#include <stdint.h>

namespace odraz {

inline constexpr int kDeviceRate = 48000;

// An output for sound, as a table of functions, so that tests can provide one too.
struct SoundOutput {
    // False if there is none. May take seconds if a server hangs.
    bool (*open)();
    // Takes up to `frames` frames and never waits. Returns how many it took, or -1 if the device is lost; it
    // may then be opened again.
    int (*write)(const int16_t *samples, int frames);
    // The number of frames that it has taken and not yet played; 0 or less if it is unknown.
    int64_t (*delay)();
};

// The system's usual output. Prints nothing to standard error.
extern const SoundOutput kSystemSound;
extern const char kNoSound[]; // what is missing if it does not open

} // namespace odraz
