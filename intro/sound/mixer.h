// All that sounds: voices, what they send to the room and its echo, and the two channels that come of it. A
// slow compressor drives quiet scenes nearer to the loud ones, and leaves every hit its edge.
//
// Stereo, 48 kHz, a block of 5 ms at a time; a row of the film is 25 blocks. Nothing is allocated, and a
// block depends on what was played before and on nothing else: the bits are the same on every processor.
#pragma once

#include "sound/note.h"
#include "sound/reverb.h"

namespace odraz {

inline constexpr int kBlocksPerRow = 25; // 8 rows a second
inline constexpr int kVoices = 128;
inline constexpr int kVoicesAtOnce = 16; // notes that may begin on one row; more may be lost

struct Mixer;
// Plays all notes of a row.
using RowPlayer = void (*)(Mixer &mixer, int row);

// All zeros except the player: silence at the start of the film.
struct Mixer {
    RowPlayer player;
    int block;    // the next one
    float ducked; // how far loud instruments push the others down: 0 .. 1
    bool hushed;  // the player's: all is silent, 30 ms from then on, until it says otherwise
    float power;  // mean square of all, over a tenth of a second as it grows and a second as it falls
    float gain;   // of all, at the last block's end
    int voiceCount;
    int quietest; // index of the quietest voice, in the last block
    Voice voices[kVoices];
    Reverb reverb;
    Echo echo;
    // Of one voice, and of all: zero between blocks
    Float8 voice[kBlock], dry[kBlock], wet[kBlock], late[kBlock];
};

// Begins a note with the next block. Ignores it if its key or velocity is not positive, its room is negative,
// one of them is NaN, or kVoices voices sound already. Partials above 20 kHz are silent, and so is a note
// whose length is NaN.
void playNote(Mixer &mixer, const Note &note);

// Renders the next block: kBlock pairs of left and right, within -1 .. 1. With null, time goes on without
// rendering, at hardly any cost: the voices are as they would be, the room and the echo are not.
void renderBlock(Mixer &mixer, float *stereo);

// Goes to a block as if everything before it had been rendered, except that room and echo hold only what
// sounded in the 8 seconds before.
void seekBlock(Mixer &mixer, int block);

} // namespace odraz
