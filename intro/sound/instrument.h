// An instrument: the numbers that determine all partials of a note.
//
// Partial k = 1, 2, ... has k^stretch times the note's pitch: `stretch` is 1 for strings and pipes, and 1.4
// to 1.8 for glass, bars and bells, whose partials are further apart. Its amplitude is k^-tilt, and it
// decays k^damp times as fast as the first. Risset and Mathews, "Analysis of musical-instrument tones",
// Physics Today 22(2), 1969. A partial is a sine, or a band of noise: for brushes, breath and wind.
#pragma once

namespace odraz {

inline constexpr int kSampleRate = 48000; // Hz
inline constexpr int kBlock = 240;        // samples rendered at a time: 5 ms

struct Instrument {
    int partials = 4;  // 4 .. 32, a multiple of 4; with noise 4. Those above kHighest Hz are left out
    float noise = 0;   // 0: sines; else the width of the bands of noise, as a multiple of their pitch
    float level = 1;   // amplitude of the first partial at velocity 1; 1 is full scale
    float stretch = 1; // exponent
    float scatter = 0; // maximal random offset of each partial, as a multiple of the pitch; 1: noise
    float tilt = 0;    // exponent at velocity 1
    float softer = 0;  // added to the exponent at velocity 0: soft notes are dark
    float decay = 1;   // seconds until the first partial has fallen by 60 dB
    float damp = 0;    // exponent
    // Seconds. If below a block, the note is struck: all partials begin together, so it is loudest at once
    float attack = 0.001f;
    float release = 1;  // seconds from the note's end to silence
    float detune = 0;   // share by which a partial's left copy is sharp and its right copy flat
    float spread = 0;   // spread of both copies' start phases, turns: 0 a point .. 1 all around
    float bend = 0;     // pitch offset at the start, as a share of the pitch: drums
    float bendTime = 1; // half-life of the offset, seconds; below 0 it grows: a riser
    float vibrato = 0;  // amplitude of the vibrato of sines, as a share of the pitch
    float room = 0;     // send to the room, as a share of the dry sound
    float echo = 0;     // send to the echo, likewise
    float ducks = 0;    // share by which it lowers instruments that can be ducked: 0 .. 1
    float ducked = 0;   // share by which others can lower it: 0 .. 1
};

inline constexpr float kHighest = 20000; // Hz: no partial is higher, so nothing aliases

} // namespace odraz
