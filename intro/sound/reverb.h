// The room that answers, and an echo in tempo. Both take and give eight lanes, 0 to 3 the left ones.
//
// The room is a feedback delay network of eight lines, one a lane: what comes out of them is mixed by a
// Hadamard matrix and goes in again, so that echoes multiply until they are a room's. A line's loss follows
// from its length, so that all modes die alike, and high ones faster, by a low-pass in each. The lengths
// drift slowly, so that no mode rings. Jot and Chaigne, "Digital delay networks for designing artificial
// reverberators", 90th AES convention, 1991.
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
    Float8 low; // what the low-passes remember
    int at;
};

// Adds what the room makes of a block to `out`.
void renderReverb(Reverb &reverb, int block, const Float8 *in, Float8 *out);

struct Echo {
    static constexpr int kBlocks = 75; // three rows
    Float8 line[kBlocks * kBlock];
};

// Adds the echoes of a block to itself; every echo changes sides.
void renderEcho(Echo &echo, int block, Float8 *inOut);

} // namespace odraz
