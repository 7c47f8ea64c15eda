// Sound output: 48,000 frames a second. A frame is two samples of 16 bits, left and right.
#pragma once

#include <stdint.h>

namespace odraz {

inline constexpr int kDeviceRate = 48000;
inline constexpr int kDeviceBlock = 240; // frames in a block of the film's sound: 5 ms

// An output as a table of functions, so that tests can provide one too.
struct SoundOutput {
    // Returns false if there is no device. May take seconds if a server hangs.
    bool (*open)();
    // Accepts up to `frames` frames, without waiting. Returns the number accepted, or -1 if the device is
    // lost; it may then be opened again.
    int (*write)(const int16_t *samples, int frames);
    // Returns the number of frames accepted but not yet played; 0 or less if it is unknown.
    int64_t (*delay)();
};

// The system's default output. It prints nothing to standard error.
extern const SoundOutput kSystemSound;
extern const char kNoSound[]; // the doctor's line if kSystemSound does not open

} // namespace odraz
