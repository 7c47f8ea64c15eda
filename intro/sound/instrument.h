// An instrument: numbers that determine all of a note's partials.
//
// Partial k = 1, 2, ... sounds at k^stretch times the note's pitch: `stretch` is 1 for strings and pipes,
// and 1.4 to 1.8 for glass, bars and bells, whose partials lie further apart. Its amplitude is k^-tilt, and
// it dies k^damp times as fast as the first. Risset and Mathews, "Analysis of musical-instrument tones",
// Physics Today 22(2), 1969. A partial is a sine, or a band of noise there: brushes, breath, wind.
#pragma once

namespace odraz {

inline constexpr int kSampleRate = 48000; // Hz
inline constexpr int kBlock = 240;        // samples that are rendered at a time: 5 ms

struct Instrument {
    int partials = 4;  // 4 .. 32, a multiple of 4, and 4 of noise; those above kHighest Hz are left out
    float noise = 0;   // 0: sines; else bands of noise, of this width as a multiple of their pitch
    float level = 1;   // amplitude of the first partial at velocity 1; 1 is full scale
    float stretch = 1; // exponent
    float scatter = 0; // each partial is off by up to this multiple of the pitch: 0 tones .. 1 noise and more
    float tilt = 0;    // exponent, at velocity 1 ...
    float softer = 0;  // ... and how much more at velocity 0: soft notes are dark
    float decay = 1;   // seconds until the first partial has fallen by 60 dB
    float damp = 0;    // exponent
    // Seconds. Below a block the note is struck: all partials begin together, so that it is loudest at once
    float attack = 0.001f;
    float release = 1;  // seconds from the note's end to silence
    float detune = 0;   // the left copy of a partial is sharp, the right one flat, by this share
    float spread = 0;   // how far their phases are apart at the start, turns: 0 a point .. 1 all around
    float bend = 0;     // a drum: it begins at 1 + bend times its pitch,
    float bendTime = 1; // and half of that is gone after this time, in seconds; below 0 it grows: a riser
    float vibrato = 0;  // how far the pitch of sines swings up and down, as a share of it
    float room = 0;     // sent to the room, as a share of what is heard dry
    float echo = 0;     // ... and to the echo
    float ducks = 0;    // how far it pushes other instruments down: 0 .. 1
    float ducked = 0;   // how far others may push it down: 0 .. 1
};

inline constexpr float kHighest = 20000; // Hz: no partial is above, so nothing aliases

} // namespace odraz
