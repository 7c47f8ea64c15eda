// The reverberation of a room, and an echo in tempo. Both have eight lanes; lanes 0 to 3 are on the left.
//
// Three allpasses diffuse the input, so that the first echoes are not clicks (Schroeder, "Natural sounding
// artificial reverberation", 1962). The room is a feedback delay network of eight lines, one for each lane: a
// Hadamard matrix mixes their outputs and feeds them back into the lines. A line's loss follows from its
// length, so that all modes decay equally fast; a low-pass in each line makes high frequencies decay faster.
// The lengths drift slowly, so that no mode rings. Jot and Chaigne, "Digital delay networks for designing
// artificial reverberators", 90th AES convention, 1991.
#pragma once

#include "base/float8.h"
#include "sound/instrument.h"

namespace odraz {

inline constexpr float kDecay = 3.4f;     // seconds for 60 dB, at low frequencies
inline constexpr float kDecayHigh = 1.3f; // likewise, at the highest frequencies
inline constexpr float kDrift = 9;        // maximal deviation from a line's mean length, samples

struct Reverb {
    static constexpr int kLength = 8192; // a power of two above the longest line
    Float8 lines[kLength];
    Float8 diffuser[3][1024]; // longer than their delays
    Float8 low;               // state of the low-passes
    int at;
};

// Sends a block into the room, and adds the room's output to `out`.
void renderReverb(Reverb &reverb, int block, const Float8 *in, Float8 *out);

struct Echo {
    static constexpr int kBlocks = 75; // three rows
    Float8 line[kBlocks * kBlock];
};

// Sends a block into the echo, both channels summed. Adds the repeats, on the left and the right in turn, to
// `dry` and to `wet`, the input of the room.
void renderEcho(Echo &echo, int block, const Float8 *in, Float8 *dry, Float8 *wet);

} // namespace odraz
