// All that sounds: voices, what they send to the room and its echo, and the two channels that come of it.
//
// Stereo, 48 kHz, a block of 5 ms at a time; a row of the film is 25 blocks. Nothing is allocated, and a
// block depends on what was played before and on nothing else: the bits are the same on every processor.
#pragma once

#include "sound/note.h"
#include "sound/reverb.h"

namespace odraz {

inline constexpr int kBlocksPerRow = 25; // 8 rows a second
inline constexpr int kVoices = 128;
inline constexpr int kVoicesAtOnce = 16; // so many notes may begin on one row: more are not heard

struct Mixer;
// Plays all notes of a row.
using Player = void (*)(Mixer &mixer, int row);

// All zeros except the player: silence at the start of the film.
struct Mixer {
    Player player;
    int block;    // the next one
    float ducked; // how far the loud push the others down: 0 .. 1
    int voiceCount;
    int quietest; // of the voices, before the row that is begun
    Voice voices[kVoices];
    Reverb reverb;
    Echo echo;
    Float8 voice[kBlock], dry[kBlock], wet[kBlock]; // of one voice, and of all: zero between blocks
};

// Begins a note with the next block, unless its key or its velocity is not positive, its room negative, or
// one of them a NaN. What is above 20 kHz is not heard, nor what has a NaN for its length.
void playNote(Mixer &mixer, const Note &note);

// Renders the next block: kBlock pairs of left and right, within -1 .. 1. Null goes on without rendering,
// which costs nearly nothing: voices are where they would be, the room and the echo are not.
void renderBlock(Mixer &mixer, float *stereo);

// Goes to a time as if everything before it had been rendered, except that the room forgets what was more
// than some seconds before.
void seekBlock(Mixer &mixer, int block);

} // namespace odraz
