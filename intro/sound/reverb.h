// The room that answers, and an echo in tempo. Both take and give eight lanes, 0 to 3 the left ones.
//
// Three allpasses diffuse what enters the room, so that its first echoes are not clicks (Schroeder,
// "Natural sounding artificial reverberation", 1962). The room is a feedback delay network of eight lines,
// one a lane: their outputs are mixed by a Hadamard matrix and fed back into the lines. A line's loss
// follows from its length, so that all modes decay alike; a low-pass in each line makes high frequencies
// decay faster. The lengths drift slowly, so that no mode rings. Jot and Chaigne, "Digital delay networks
// for designing artificial reverberators", 90th AES convention, 1991.
#pragma once

#include "base/float8.h"
#include "sound/instrument.h"

namespace odraz {

inline constexpr float kDecay = 3.4f;     // seconds for 60 dB, at low frequencies
inline constexpr float kDecayHigh = 1.3f; // ... at the highest
inline constexpr float kDrift = 9;        // samples above and below a line's mean length

struct Reverb {
    static constexpr int kLength = 8192; // a power of two above the longest line
    Float8 lines[kLength];
    Float8 diffuser[3][1024]; // longer than their delays too
    Float8 low;               // state of the low-passes
    int at;
};

// Sends a block into the room, and adds what comes back to `out`.
void renderReverb(Reverb &reverb, int block, const Float8 *in, Float8 *out);

struct Echo {
    static constexpr int kBlocks = 75; // three rows
    Float8 line[kBlocks * kBlock];
};

// Sends both sides of a block into the echo, as one. What comes back, first on the left, then on the right
// and so on, is added to what is heard dry and to what goes to the room.
void renderEcho(Echo &echo, int block, const Float8 *in, Float8 *dry, Float8 *wet);

} // namespace odraz
