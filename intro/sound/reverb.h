// The room that answers, and an echo in tempo. Both take and give eight lanes, 0 to 3 the left ones.
//
// The room is a feedback delay network of eight lines, one a lane: their outputs are mixed by a Hadamard
// matrix and go in again, so that echoes multiply until they sound like a room. A line's loss follows from
// its length, so that all modes decay alike; a low-pass in each line makes high frequencies decay faster. The
// lengths drift slowly, so that no mode rings. Jot and Chaigne, "Digital delay networks for designing
// artificial reverberators", 90th AES convention, 1991.
#pragma once

#include "base/float8.h"
#include "sound/instrument.h"

namespace odraz {

inline constexpr float kDecay = 3.4f;     // seconds for 60 dB, at low frequencies
inline constexpr float kDecayHigh = 1.3f; // ... at the highest
inline constexpr float kDrift = 9;        // samples, either way of a line's mean length

struct Reverb {
    static constexpr int kLength = 8192; // a power of two above the longest line
    Float8 lines[kLength];
    Float8 low; // state of the low-passes
    int at;
};

// Sends a block into the room, and adds what comes back to `out`.
void renderReverb(Reverb &reverb, int block, const Float8 *in, Float8 *out);

struct Echo {
    static constexpr int kBlocks = 75; // three rows
    Float8 line[kBlocks * kBlock];
};

// Adds the echoes of a block to itself; every echo changes sides.
void renderEcho(Echo &echo, int block, Float8 *inOut);

} // namespace odraz
