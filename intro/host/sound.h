// Where sound goes: 48,000 frames a second of two 16-bit samples, left and right.
#pragma once

#include <stdint.h>

namespace odraz {

inline constexpr int kDeviceRate = 48000;

// What plays sound, as a table, so that tests can play it too.
struct SoundOutput {
    // False where there is none. May take seconds where a server hangs.
    bool (*open)();
    // Takes up to `frames` and never waits: how many it took, or -1 when it is lost and may be opened again.
    int (*write)(const int16_t *samples, int frames);
    // Frames that it has taken and nobody has heard yet; 0 or less where it cannot tell.
    int64_t (*delay)();
};

// The system's usual output. Says nothing on standard error, whatever happens.
extern const SoundOutput kSystemSound;
extern const char kNoSound[]; // what is missing where it does not open

} // namespace odraz
