// The tune of the music.
#pragma once

namespace odraz {

// Eight bars, a tone a beat. The tune leaps a fifth and steps back, then leaps an octave and descends the
// scale to the end: the scale that the strips of the door climb.
inline constexpr char kTune[] = "D-aGa--GF-EDE---D-dcb--aGFECD---";
inline constexpr int kAnswer = 16; // the beat at which its second half begins

// Its mirror image about F, the second voice: leaps up become leaps down, descents climb. In the second bar C
// replaces D, and in the sixth D replaces C, where the image would clash with the tune two bars later.
inline constexpr char kMirrored[] = "a-DEC--EF-GaG---a-ABD--DEFGba---";

// The bass below the tune, a tone each half bar: roots, and tones that lead from one to the next.
inline constexpr char kBassLine[] = "DFFCBDACDFGBACDA";

} // namespace odraz
