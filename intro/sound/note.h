// A note as a sum of partials, eight at a time: lanes 0 to 3 are heard on the left, 4 to 7 are the same
// partials on the right, a little out of tune with them.
//
// A note is a function of time and has no state: the phase of a partial is the time multiplied by an integer
// of 2^-32 turns, its amplitude is a power of two, and only within a block are phasors turned from sample to
// sample. So phasors need no renormalising, rendering can begin at any time in a note, and no number becomes
// denormal.
//
// Bands of noise are random numbers of the time, in eight state-variable filters of the zero-delay form,
// which stay in tune and stable however fast they are swept. Their state is the only one: it is forgotten
// within a few periods. Zavalishin, "The Art of VA Filter Design", 2012, 4; Simper, "Linear trapezoidal
// integrated SVF", 2013.
#pragma once

#include "base/float8.h"
#include "sound/instrument.h"

namespace odraz {

struct Note {
    const Instrument *instrument;
    float key;      // semitones, MIDI's: 69 is a' = 440 Hz; above 0, and below 20 kHz to be heard
    float velocity; // 0 .. 1, and a little above where a phrase swells
    float length;   // seconds until it is released
    float room;     // factor of the instrument's send to the room, from 0, and below 1 of its width as well
    float left = 0; // 1: on the left alone, 0: in the middle
};

// A note as it sounds.
struct Voice {
    Note note;
    int start; // block of the film, kBlock samples each
    int groups;
    struct Group {
        Uint8 turn, phase; // in 2^-32 turns: per sample, and at the start
        Float8 hertz;      // without bend and vibrato
        Float8 amplitude;  // at the start
        Float8 fall;       // change of log2(amplitude) per sample: not above 0
    } group[8];
    Float8 band, low; // the filters' integrators

    // The envelope, and the amplitude of the first partial with it, `time` samples after the start; 0 after
    // the end.
    float envelope(float time) const;
    float loudness(float time) const;
};

// A partial below this amplitude (-110 dB) is left out; a voice that has fallen below it is over.
inline constexpr float kInaudible = 3e-6f;

void beginVoice(Voice &voice, const Note &note, int block);

// Adds a block to `out`, kBlock samples of eight lanes, `time` samples after the voice's start (a multiple of
// kBlock); its level goes from gain0 to gain1, both multiplied by the envelope.
void renderVoice(Voice &voice, int time, float gain0, float gain1, Float8 *out);

} // namespace odraz
