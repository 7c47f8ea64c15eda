// A note as a sum of partials, eight at a time: lanes 0 to 3 are on the left, lanes 4 to 7 are the same
// partials on the right, slightly detuned.
//
// A note of sines is a function of time and has no state. A partial's phase is the time multiplied by an
// integer, in units of 2^-32 turns; its amplitude is a power of two. Phasors are rotated from sample to
// sample only within a block. So they need no renormalising, rendering can begin at any time in a note, and
// no number becomes denormal.
//
// Bands of noise are random numbers, hashed from the time, through eight state-variable filters in zero-delay
// form, which stay in tune and stable however fast they are swept. Only these filters have a state, which
// fades within a few periods. Zavalishin, "The Art of VA Filter Design", 2012, 4; Simper, "Linear trapezoidal
// integrated SVF", 2013.
#pragma once

#include "base/float8.h"
#include "sound/instrument.h"

namespace odraz {

struct Note {
    const Instrument *instrument;
    float key;      // MIDI semitones: 69 is a' = 440 Hz; above 0, and below 20 kHz to be audible
    float velocity; // 0 .. 1, or a little above where a phrase swells
    float length;   // seconds until it is released
    float room; // 0 or more: factor of the instrument's send to the room; below 1 it also narrows the note
    float left = 0; // 1: on the left only, 0: in the middle
};

// A note that is sounding.
struct Voice {
    Note note;
    int start; // index of its first block in the film
    int groups;
    struct Group {
        Uint8 turn, phase; // in 2^-32 turns: per sample, and at the start
        Float8 hertz;      // without bend and vibrato
        Float8 amplitude;  // at the start
        Float8 fall;       // change of log2(amplitude) per sample: 0 or negative
    } group[8];
    Float8 band, low; // the filters' integrators

    // The envelope, and its product with the first partial's amplitude, `time` samples after the start.
    float envelope(float time) const;
    float loudness(float time) const;
};

// Partials below this amplitude (-110 dB) are left out, and a voice ends when it falls below.
inline constexpr float kInaudible = 3e-6f;

void beginVoice(Voice &voice, const Note &note, int block);

// Adds a block to `out`: kBlock samples of eight lanes, from `time` samples after the voice's start (a
// multiple of kBlock). Its level goes from gain0 to gain1, both multiplied by the envelope.
void renderVoice(Voice &voice, int time, float gain0, float gain1, Float8 *out);

} // namespace odraz
