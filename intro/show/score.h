// How music is written down: chords by the bar, parts that play them, and the sounds of events (music.h has
// them).
//
// Bars and rows count from the start of a scene's story, so that music moves with its scene. A chord is five
// tones of the scale, stacked in thirds on its root: A to G in D minor, d in D major. A is the dominant:
// under it, C is C sharp. A part plays k strokes spread evenly over n rows (Toussaint, "The Euclidean
// algorithm generates traditional musical rhythms", Bridges 2005), and takes the tones of its line one after
// the other. Velocities are phrased: bars, then half bars, stand out, and every four bars swell and fall away
// (after Friberg, Bresin and Sundberg, "Overview of the KTH rule system for musical performance", Advances in
// Cognitive Psychology 2, 2006).
#pragma once

#include "show/events.h"
#include "show/instruments.h"
#include "sound/mixer.h"

namespace odraz {

// Steps of the scale from D to a letter: A lies below D, a above.
constexpr int stepOf(char letter) { return (letter & 31) - 'D' % 32 + (letter < 'a' ? 0 : 7); }

// A chord for every bar of every scene: a letter, as above.
extern const char *const kChords[kSceneCount];

// How something is played.
struct Articulation {
    InstrumentId instrument;
    int8_t octave; // 4 begins at d' = 293 Hz
    // How many tones at once: each a third above the last, every second one an octave higher, the fifth as
    // well. If several, each is moved by octaves to where it lies next to those of other chords.
    uint8_t stack;
    uint8_t room;     // per cent of what the instrument sends to the room, and of its width
    uint8_t left = 0; // per cent: how far it stands on the left
};

struct Part {
    SceneId scene;
    uint8_t from, to; // bars: [from, to)
    Articulation articulation;
    uint8_t strokes, rows; // how many strokes in how many rows
    uint8_t soft, loud;    // velocity at the start and at the end, per cent
    // 0 .. 9: a tone of the chord; A .. G, a .. g: one of the scale; . is a rest, - holds the last one on
    const char *line;
};

// The sound of an event.
struct EventSound {
    SceneId scene;
    uint8_t loud; // velocity, per cent
    int16_t row;
    Articulation articulation;
    char tone; // as in a part's line

    consteval EventSound(EventId event, Articulation articulation, uint8_t loud, char tone)
        : scene(kEvents[event].scene), loud(loud), row(kEvents[event].row), articulation(articulation),
          tone(tone) {}
};

// Plays the notes that begin on a row of the film, from 0 on, and sets the mixer's width. It is a RowPlayer
// (mixer.h).
void playRow(Mixer &mixer, int row);

} // namespace odraz
