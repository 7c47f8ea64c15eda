// The tune that the music is made of.
#pragma once

namespace odraz {

// The tune: eight bars, a tone a beat. It leaps a fifth and steps back, and then the octave, which it walks
// down to the end: the scale that the strips of the door climb.
inline constexpr char kTune[] = "D-aGa--GF-EDE---D-dcb--aGFECD---";
inline constexpr int kAnswer = 16; // its second half: the beat at which it begins

// Its mirror image about F, the second voice: what leaps up falls, and what walks down climbs. C stands for D
// in the second bar, and D for C in the sixth, where the image would clash with the tune two bars later.
inline constexpr char kMirrored[] = "a-DEC--EF-GaG---a-ABD--DEFGba---";

// The bass below the tune, a tone each half bar: roots, and what leads from one to the next.
inline constexpr char kBassLine[] = "DFFCBDACDFGBACDA";

} // namespace odraz
