// The door of light as an instrument: its strips are the keys D E F G a b c d.
#pragma once

#include "show/hall.h"

namespace odraz {

// Adds to the strips what the tones of a line light: a strip flares with its tone, and is dead a beat later.
// row: since the line's first tone. every: the rows from a tone to the next. A tone is a letter; tones below
// D light the strip an octave higher; `.` and `-` light none. `full`: the light of a flare.
void playDoor(HallLight &light, const char *line, float row, float every, float full);

// Adds an ember to every strip, a tenth of a flare, and scales the strips, so that they light the hall
// equally (about `level` in all) whether the tune plays or rests.
void balanceDoor(HallLight &light, float level);

} // namespace odraz
