// The mixer: voices, their sends to the room and the echo, and two channels of output. A slow compressor
// brings quiet scenes closer to loud ones and keeps the attack of every hit.
//
// Renders stereo at 48 kHz, a block of 5 ms at a time; a row of the film is 25 blocks. Allocates nothing. A
// block depends only on what was played before: its bits are the same on every processor.
#pragma once

#include "sound/note.h"
#include "sound/reverb.h"

namespace odraz {

inline constexpr int kBlocksPerRow = 25; // 8 rows a second
inline constexpr int kVoices = 128;
inline constexpr int kVoicesAtOnce = 16; // notes that can begin on one row; more may be lost

struct Mixer;
// Plays all notes of a row.
using RowPlayer = void (*)(Mixer &mixer, int row);

// All zeros except the player: silence at the start of the film.
struct Mixer {
    RowPlayer player;
    int block;       // index of the next block
    float ducked;    // share by which loud instruments now lower the others: 0 .. 1
    bool muted;      // set by the player: the gain falls to 0 within 30 ms, and stays 0 until this is cleared
    float level;     // set by the player: dB by which the compressed mix is louder. A step takes a block
    float crossfeed; // set by the player: the share of each channel that the other gets; 0.5: both are equal
    float power;     // mean square of the mix, over 0.1 s while it grows and 1 s while it falls
    float gain;      // gain of the mix, at the last block's end
    int voiceCount;
    int quietest; // index of the quietest voice, in the last block
    Voice voices[kVoices];
    Reverb reverb;
    Echo echo;
    // Buffers: one voice, and the sums of all voices: dry, for the room and for the echo. Zero between blocks
    Float8 voice[kBlock], dry[kBlock], wet[kBlock], echoed[kBlock];
};

// Begins a note with the next block. Ignores it if its key or velocity is not positive, its room is negative,
// one of them is NaN, or kVoices voices are sounding. Partials above 20 kHz and notes of length NaN are
// silent.
void playNote(Mixer &mixer, const Note &note);

// Renders the next block: kBlock pairs of left and right, within -1 .. 1. With null, time advances without
// rendering, at hardly any cost: voices are kept up to date, but room and echo are not.
void renderBlock(Mixer &mixer, float *stereo);

// Seeks a block. Then room and echo have only the last 8 seconds; all else is as if rendered from the start.
void seekBlock(Mixer &mixer, int block);

} // namespace odraz
