// The notation of the music (music.h): chords for each bar, parts that play them, and sounds of events.
//
// Bars and rows count from the start of a scene's story, so that music moves with its scene. A chord is the
// letter of its root: A to G in D minor, d in D major. Its five tones are stacked in thirds. In A, the
// dominant, C is C sharp. A part plays k strokes spread evenly over n rows (Toussaint, "The Euclidean
// algorithm generates traditional musical rhythms", Bridges 2005), with the tones of its line in turn.
// Velocities are phrased: bars are stressed, half bars less, and every four bars swell and fade (after
// Friberg, Bresin and Sundberg, "Overview of the KTH rule system for musical performance", Advances in
// Cognitive Psychology 2, 2006).
#pragma once

#include "show/events.h"
#include "show/instruments.h"
#include "sound/mixer.h"

namespace odraz {

// Returns the steps of the scale from D to a letter: A is below D, a above.
constexpr int stepOf(char letter) { return (letter & 31) - 'D' % 32 + (letter < 'a' ? 0 : 7); }

// A chord for every bar of every scene, as a letter (see above).
extern const char *const kChords[kSceneCount];

// How a part or an event's sound is played.
struct Articulation {
    InstrumentId instrument;
    int8_t octave; // 4 begins at d' = 293 Hz

    // The number of tones at once, in thirds. Two or more are shifted by octaves, so that successive chords
    // are close: every second tone and the fifth go into the octave above.
    uint8_t stack;
    uint8_t room;    // per cent of the instrument's send to the room, and of its width
    int8_t left = 0; // per cent to the left: 0 is in the middle, -100 on the right
};

struct Part {
    SceneId scene;
    uint8_t bars[2]; // [from, to)
    Articulation sound;
    uint8_t strokes[2];  // their number, and the number of rows over which they are spread
    uint8_t velocity[2]; // at the start and at the end, per cent
    // 0 .. 9: a tone of the chord; A .. G, a .. g: a tone of the scale; . is a rest, - holds the last tone
    const char *line;
};

// The sound of an event.
struct EventSound {
    SceneId scene;
    uint8_t velocity; // per cent
    int16_t row;
    Articulation articulation;
    char tone; // as in a part's line

    consteval EventSound(EventId event, Articulation articulation, uint8_t velocity, char tone)
        : scene(kEvents[event].scene), velocity(velocity), row(kEvents[event].row),
          articulation(articulation), tone(tone) {}
};

// A RowPlayer (mixer.h): plays the notes that begin on a row, and sets the mixer's level, crossfeed and
// silence.
void playRow(Mixer &mixer, int row);

} // namespace odraz
