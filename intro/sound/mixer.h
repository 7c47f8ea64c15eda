// The mixer: voices, their sends to the room and to the echo, and the two channels of output. A slow
// compressor brings quiet scenes closer to the loud ones, and keeps the attack of every hit.
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
    bool hushed;  // set by the player: the gain falls to 0 within 30 ms, and stays 0 until this is cleared
    float narrow; // set by the player: the share of each side that the other takes; 0.5: both are the same
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

// Begins a note with the next block. Ignores it if its key or velocity is not positive, its room is
// negative, one of them is NaN, or if kVoices voices are sounding. Partials above 20 kHz are silent, and so
// is a note whose length is NaN.
void playNote(Mixer &mixer, const Note &note);

// Renders the next block: kBlock pairs of left and right, within -1 .. 1. With null, time goes on without
// rendering, at hardly any cost: voices are kept up to date, the room and the echo are not.
void renderBlock(Mixer &mixer, float *stereo);

// Goes to a block as if everything before it had been rendered, except that room and echo hold only what
// sounded in the 8 seconds before.
void seekBlock(Mixer &mixer, int block);

} // namespace odraz
