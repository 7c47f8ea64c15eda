// The tune of the music.
#pragma once

namespace odraz {

// Eight bars, a tone a beat. The tune leaps a fifth and steps back, then leaps an octave and descends the
// scale to the end: the scale that the strips of the door climb.
inline constexpr char kTune[] = "D-aGa--GF-EDE---D-dcb--aGFECD---";
inline constexpr int kAnswer = 16; // the beat at which its second half begins

// What the strips of the door play before the tune, a tone each half beat: the tune's two leaps. The last
// beat is empty.
inline constexpr char kDoorTune[] = "D.a.G.a.D.dcba..";

// The second voice: the tune mirrored about F, so leaps up become leaps down, and descents become climbs. It
// follows two bars after the tune. Two tones are changed where the exact image would clash with the tune: in
// the second bar from D to C, and in the sixth from C to D.
inline constexpr char kMirrored[] = "a-DEC--EF-GaG---a-ABD--DEFGba---";

// The bass below the tune, a tone each half bar: roots, and tones that lead from one to the next.
inline constexpr char kBassLine[] = "DFFCBDACDFGBACDA";

// The tones of the point of light: they sound when it enters a set. Its image answers with the same tones
// backwards.
inline constexpr char kCell[] = "ADEa....", kCellAnswer[] = "..aEDA..";

// The tune of the flake, a tone a beat: it climbs by its chords to the top of the flight.
inline constexpr char kFlight[] = "D-Fba-GaG-EGa-dcd-cbc-bab-dge---";

// A tone a beat for the bar that recalls the four sets, and for the roll after it.
inline constexpr char kStabs[] = "DFBGAEac";

} // namespace odraz
