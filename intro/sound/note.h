// A note as a sum of partials, eight at a time: lanes 0 to 3 are heard on the left, 4 to 7 are the same
// partials on the right, a little out of tune with them.
//
// It is a function of time and remembers nothing: the phase of a partial is an integer of 2^-32 turns that is
// multiplied with the time, its amplitude a power of two, and only within a block are phasors turned from
// sample to sample. So they need no renormalising, a note can be joined at any moment, and no number becomes
// denormal.
#pragma once

#include "base/float8.h"
#include "sound/instrument.h"

namespace odraz {

struct Note {
    const Instrument *instrument;
    float key;      // semitones, MIDI's: 69 is a' = 440 Hz; above 0, and below 20 kHz to be heard
    float velocity; // 0 .. 1
    float length;   // seconds until it is let go
    float room;     // how much of the instrument's send it takes, from 0; 1 is all
};

// A note as it sounds.
struct Voice {
    Note note;
    int start; // block of the film, kBlock samples each
    int groups;
    struct Group {
        Uint8 turn, phase; // 2^-32 turns: a sample, and at the start
        Float8 bend;       // turns that the bend adds in all
        Float8 amplitude;  // at the start
        Float8 fall;       // log2 of the amplitude, a sample: not above 0
    } group[8];

    // Of its envelope and its first partial at a time since its start, in samples; 0 after its end.
    float envelope(float time) const;
    float loudness(float time) const;
};

// Below this a partial is not heard, and left out; a voice that has fallen below it is over. -110 dB.
inline constexpr float kInaudible = 3e-6f;

void beginVoice(Voice &voice, const Note &note, int block);

// Adds a block to `out`, kBlock samples of eight lanes, `time` samples after the voice's start (a multiple of
// kBlock); its level goes from gain0 to gain1, the envelope not counted.
void renderVoice(const Voice &voice, int time, float gain0, float gain1, Float8 *out);

} // namespace odraz
