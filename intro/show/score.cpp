#include "show/score.h"

#include "show/show.h"

namespace odraz {

// Rounds a number to eight significant bits: the ear needs no more, and fewer bits pack better.
static consteval float operator""_s(long double x) { return fromBits((bits((float)x) + 0x8000) & ~0xffff); }

// clang-format off
constexpr Instrument kInstruments[] = {
    [kGlassDrop] = {.partials = 8, .level = 0.117_s, .stretch = 1.46_s, .scatter = 0.01_s, .tilt = 1.2_s, .softer = 1, .decay = 4.5_s, .damp = 0.9_s,
        .release = 3, .detune = 0.0004_s, .spread = 0.2_s, .room = 1},
    [kPiano] = {.partials = 20, .level = 0.134_s, .stretch = 1.003_s, .tilt = 0.9_s, .softer = 1.2_s, .decay = 7, .damp = 0.8_s,
        .release = 1.2_s, .detune = 0.0005_s, .spread = 0.25_s, .room = 0.6_s, .ducked = 0.2_s},
    [kPad] = {.partials = 12, .level = 0.077_s, .stretch = 1, .scatter = 0.002_s, .tilt = 1.2_s, .softer = 0.8_s, .decay = 60,
        .attack = 1.4_s, .release = 2.4_s, .detune = 0.0022_s, .spread = 0.5_s, .room = 0.6_s, .ducked = 0.7_s},
    [kBass] = {.partials = 8, .level = 0.139_s, .stretch = 1, .tilt = 1.1_s, .softer = 0.6_s, .decay = 9, .damp = 0.5_s,
        .attack = 0.02_s, .release = 0.5_s, .detune = 0.0008_s, .spread = 0.1_s, .room = 0.2_s, .ducked = 0.4_s},
    [kWood] = {.partials = 8, .level = 0.145_s, .stretch = 1.72_s, .scatter = 0.03_s, .tilt = 1.1_s, .softer = 0.8_s, .decay = 0.5_s, .damp = 0.6_s,
        .release = 0.3_s, .detune = 0.001_s, .spread = 0.2_s, .bend = 0.06_s, .bendTime = 0.008_s, .room = 0.7_s},
    [kPulse] = {.partials = 16, .level = 0.08_s, .stretch = 1.01_s, .tilt = 0.6_s, .softer = 0.9_s, .decay = 0.45_s, .damp = 0.5_s,
        .release = 0.1_s, .detune = 0.0006_s, .spread = 0.2_s, .room = 0.35_s},
    [kDrum] = {.partials = 8, .level = 0.342_s, .stretch = 1.6_s, .scatter = 0.05_s, .tilt = 1.5_s, .softer = 0.5_s, .decay = 0.9_s, .damp = 1.1_s,
        .release = 0.5_s, .detune = 0.001_s, .spread = 0.1_s, .bend = 1.6_s, .bendTime = 0.025_s, .room = 0.5_s, .ducks = 0.5_s},
    [kAir] = {.partials = 32, .level = 0.02_s, .stretch = 0.75_s, .scatter = 0.45_s, .tilt = 0.1_s, .softer = 0.6_s, .decay = 1.6_s, .damp = 0.2_s,
        .release = 0.5_s, .detune = 0.01_s, .spread = 1, .room = 0.8_s},
};
static_assert(sizeof kInstruments / sizeof *kInstruments == kInstrumentCount);
static_assert(
    [] {
        for (const Instrument &i : kInstruments)
            if (i.partials < 4 || i.partials > 32 || i.partials % 4)
                return false;
        return true;
    }(),
    "groups of four partials, 32 at most");

constexpr char kChords[][19] = {
    [kPoint] = "DDDDDBGD",
    [kTable] = "DDBBFFCCGGBA",
    [kFlake] = "GGDDBBFFGGAA",
    [kPatches] = "DDDDDDBFCADADA",
    [kHall] = "DDFFCCGGBFCDGGGBCA",
    [kOdraz] = "DBFCDBGAGBAD",
    [kCredits] = "ddddd",
};
static_assert(sizeof kChords / sizeof *kChords == kSceneCount);

// Scene, bars from and to; instrument, octave, tones at once, room; strokes in rows; velocity at the start and
// at the end; line.
static constexpr Part kParts[] = {
    {kPoint, 0, 5, {kGlassDrop, 5, 1, 100}, 5, 64, 40, 60, "..2.41.3"},
    {kPoint, 5, 7, {kGlassDrop, 5, 1, 100}, 4, 16, 35, 60, "02140325"},
    {kPoint, 5, 8, {kPad, 3, 4, 100}, 1, 16, 30, 80, "0"},
    {kPoint, 7, 8, {kAir, 7, 1, 100}, 3, 16, 5, 30, "0213"},

    {kTable, 0, 1, {kDrum, 1, 1, 150}, 1, 16, 80, 80, "a"},
    {kTable, 0, 12, {kPad, 3, 4, 100}, 1, 32, 45, 65, "0"},
    {kTable, 0, 12, {kBass, 2, 1, 100}, 1, 16, 60, 80, "0"},
    {kTable, 3, 12, {kWood, 4, 1, 100}, 3, 16, 45, 65, "02143"},
    {kTable, 1, 3, {kWood, 4, 1, 100}, 4, 16, 50, 65, "0.214.35"},
    {kTable, 0, 8, {kPiano, 4, 1, 100}, 1, 8, 65, 75, "a..dc..ag.a.e..."},
    {kTable, 8, 12, {kPiano, 4, 1, 100}, 1, 8, 70, 80, "f..ed..bd.bce"},
    {kTable, 8, 12, {kGlassDrop, 5, 1, 100}, 5, 32, 25, 50, "42.31"},

    {kFlake, 0, 1, {kDrum, 1, 1, 150}, 1, 16, 80, 80, "a"},
    {kFlake, 0, 12, {kBass, 2, 1, 100}, 2, 16, 60, 95, "0"},
    {kFlake, 1, 12, {kPiano, 4, 1, 100}, 8, 16, 35, 60, "02143526"},
    {kFlake, 2, 12, {kWood, 5, 1, 100}, 5, 16, 40, 70, "0314"},
    {kFlake, 3, 12, {kGlassDrop, 6, 1, 100}, 7, 16, 20, 50, "46253"},
    {kFlake, 6, 12, {kPad, 3, 4, 100}, 1, 32, 40, 90, "0"},
    {kFlake, 8, 12, {kPulse, 5, 1, 100}, 16, 16, 10, 60, "021"},
    {kFlake, 11, 12, {kAir, 7, 1, 100}, 8, 16, 5, 50, "0213"},

    {kPatches, 0, 1, {kDrum, 1, 1, 30}, 1, 16, 90, 90, "a"},
    {kPatches, 0, 1, {kAir, 6, 1, 50}, 1, 16, 90, 90, "0"},
    {kPatches, 0, 5, {kPulse, 4, 1, 20}, 5, 16, 50, 70, "0"},
    {kPatches, 1, 5, {kWood, 5, 1, 20}, 7, 16, 40, 60, "2"},
    {kPatches, 2, 5, {kPulse, 5, 1, 20}, 7, 20, 30, 50, "204"},
    {kPatches, 3, 5, {kBass, 2, 1, 50}, 1, 16, 50, 80, "0"},
    {kPatches, 5, 6, {kDrum, 1, 1, 150}, 1, 16, 70, 70, "a"},
    {kPatches, 5, 14, {kPad, 4, 3, 120}, 1, 16, 40, 80, "0"},
    {kPatches, 5, 14, {kBass, 2, 1, 100}, 1, 16, 60, 80, "0"},
    {kPatches, 9, 14, {kPiano, 4, 1, 120}, 5, 16, 35, 60, "02431"},

    {kHall, 0, 1, {kDrum, 1, 1, 150}, 1, 16, 55, 55, "a"},
    {kHall, 0, 14, {kPad, 3, 3, 120}, 1, 32, 40, 25, "0"},
    {kHall, 0, 18, {kPad, 5, 2, 150}, 1, 32, 18, 35, "1"},
    {kHall, 2, 12, {kBass, 2, 1, 100}, 1, 32, 35, 50, "0"},
    {kHall, 0, 8, {kPiano, 4, 1, 150}, 1, 8, 45, 60, "a..dc..ag..eb..."},
    {kHall, 8, 13, {kGlassDrop, 5, 1, 150}, 3, 32, 25, 35, "3142"},
    {kHall, 14, 18, {kPad, 3, 4, 100}, 1, 32, 60, 90, "0"},
    {kHall, 14, 18, {kBass, 2, 1, 100}, 2, 16, 50, 95, "0"},
    {kHall, 16, 18, {kPiano, 5, 1, 100}, 8, 16, 30, 75, "02143526"},
    {kHall, 17, 18, {kAir, 7, 1, 100}, 8, 16, 5, 50, "0213"},

    {kOdraz, 0, 12, {kPad, 3, 4, 100}, 1, 16, 75, 40, "0"},
    {kOdraz, 0, 10, {kBass, 2, 1, 100}, 2, 16, 95, 60, "0"},
    {kOdraz, 0, 6, {kDrum, 1, 1, 60}, 2, 16, 80, 80, "a"},
    {kOdraz, 0, 7, {kWood, 5, 1, 100}, 3, 8, 60, 60, "0314"},
    {kOdraz, 0, 8, {kPiano, 4, 1, 100}, 8, 16, 50, 40, "02143526"},
    {kOdraz, 1, 9, {kGlassDrop, 6, 1, 100}, 5, 16, 35, 25, "42531"},
    {kOdraz, 0, 4, {kPiano, 5, 1, 120}, 4, 16, 95, 95, "a..dc..ag.a.e..."},
    {kOdraz, 4, 8, {kPiano, 5, 1, 120}, 4, 16, 95, 70, "a..dc..ab.d.e..."},
    {kOdraz, 8, 12, {kPiano, 4, 1, 120}, 1, 16, 50, 35, "da"},

    {kCredits, 0, 1, {kPiano, 2, 2, 150}, 1, 16, 60, 60, "0"},
    {kCredits, 0, 2, {kPad, 4, 5, 150}, 1, 32, 35, 35, "0"},
};
static_assert(
    [] {
        for (const Part &p : kParts) {
            int bars = 0;
            while (kChords[p.scene][bars]) ++bars;
            if (p.from >= p.to || p.to > bars) return false;
        }
        return true;
    }(),
    "a part begins before it ends, within its scene's bars");

// Event; instrument, octave, tones at once, room; velocity; tone.
static constexpr Heard kHeard[] = {
    {kLightIsBorn, {kGlassDrop, 6, 1, 120}, 60, '2'},
    {kLightGrows, {kGlassDrop, 5, 1, 120}, 60, '0'},
    {kCausticFalls, {kGlassDrop, 5, 2, 120}, 60, '2'},
    {kWordComes, {kGlassDrop, 6, 1, 120}, 50, 'D'},
    {kWordStands, {kPiano, 2, 1, 120}, 90, 'D'},
    {kWordStands, {kBass, 1, 1, 120}, 90, 'D'},
    {kBallsSetOff, {kWood, 4, 2, 120}, 80, '0'},
    {kGeneration1, {kPiano, 4, 3, 120}, 60, '0'},
    {kGeneration2, {kGlassDrop, 5, 3, 120}, 70, '0'},
    {kGeneration3, {kGlassDrop, 6, 4, 120}, 90, '0'},
    {kPatchIsVisited, {kGlassDrop, 5, 1, 30}, 70, 'D'},
    {kHalfCubeRises, {kGlassDrop, 4, 2, 40}, 60, '0'},
    {kHalfCubeOpens, {kGlassDrop, 5, 3, 40}, 70, '0'},
    {kPatchTakesColour, {kPiano, 4, 2, 60}, 70, '0'},
    {kDirectLight, {kPiano, 3, 2, 80}, 85, '0'},
    {kBounce1, {kPiano, 3, 3, 100}, 80, '0'},
    {kBounce2, {kPiano, 3, 4, 120}, 80, '0'},
    {kBounce3, {kPiano, 3, 5, 150}, 80, '0'},
    {kLamp1, {kPiano, 5, 1, 150}, 70, 'a'},
    {kLamp2, {kPiano, 5, 1, 150}, 65, 'c'},
    {kLamp3, {kPiano, 5, 1, 150}, 60, 'd'},
    {kStrip1, {kPiano, 4, 1, 120}, 70, 'D'},
    {kStrip2, {kPiano, 4, 1, 120}, 72, 'E'},
    {kStrip3, {kPiano, 4, 1, 120}, 74, 'F'},
    {kStrip4, {kPiano, 4, 1, 120}, 78, 'G'},
    {kStrip5, {kPiano, 4, 1, 120}, 82, 'a'},
    {kStrip6, {kPiano, 4, 1, 120}, 86, 'b'},
    {kStrip7, {kPiano, 4, 1, 120}, 90, 'c'},
    {kStrip8, {kPiano, 4, 3, 120}, 100, 'd'},
    {kLampLights, {kPiano, 4, 3, 150}, 70, '0'},
    {kBall1, {kWood, 4, 2, 120}, 70, '0'},
    {kBall2, {kGlassDrop, 6, 1, 120}, 90, '1'},
    {kBall3, {kWood, 4, 1, 120}, 70, '2'},
    {kBall4, {kWood, 4, 1, 120}, 70, '3'},
    {kBall5, {kWood, 4, 1, 120}, 70, '4'},
    {kDoorDies, {kGlassDrop, 5, 2, 120}, 70, '0'},
    {kOuterLampsDie, {kGlassDrop, 5, 2, 120}, 60, '2'},
    {kBall3Leaves, {kGlassDrop, 5, 1, 120}, 60, '1'},
    {kBall1Leaves, {kGlassDrop, 6, 1, 120}, 60, '0'},
    {kLine1, {kGlassDrop, 6, 1, 120}, 60, 'D'},
    {kLine2, {kGlassDrop, 6, 1, 120}, 55, 'F'},
    {kLine3, {kGlassDrop, 6, 1, 120}, 50, 'e'},
};
// clang-format on

namespace {

constexpr float kRing = 16; // rows that the sound of an event lasts

constexpr bool isHeard(const Event &event) {
    for (const Heard &h : kHeard)
        if (h.scene == event.scene && h.row == event.row) return true;
    return false;
}
static_assert(
    [] {
        for (const Event &e : kEvents)
            if (e.heard != isHeard(e)) return false;
        return true;
    }(),
    "what is marked as heard has a sound, and nothing else has");

// Steps of the scale from D to a letter: A lies below D, a above.
int stepOf(char letter) { return (letter & 31) - 'D' % 32 + (letter < 'a' ? 0 : 7); }

void strike(Mixer &m, const Articulation &articulation, char tone, char chord, float velocity, float rows) {
    static constexpr int8_t kMinor[] = {0, 2, 3, 5, 7, 8, 10}, kMajor[] = {0, 2, 4, 6, 7, 9, 11};
    if (tone == '.') return;
    int root = stepOf((char)(chord & ~32));
    int step = tone < 'A' ? root + 2 * (tone - '0') : stepOf(tone);
    for (int i = 0; i < articulation.stack; ++i) {
        int at = step + 2 * i + (i & 1) * 7 + 70;
        const int8_t *scale = chord < 'a' ? kMinor : kMajor;
        float key = (float)(12 * (at / 7 - 10 + articulation.octave) + scale[at % 7] + 14);
        playNote(m, {&kInstruments[articulation.instrument], key, velocity, rows * 0.125f,
                     (float)articulation.room * 0.01f});
    }
}

} // namespace

void playRow(Mixer &m, int row) {
    if (row >= (int)kFilm.endRow) return;
    Moment now = momentAt(kFilm, row);
    int scene = now.shot->scene, story = (int)now.storyRow, bar = story / 16;
    char chord = kChords[scene][bar];
    for (const Part &p : kParts) {
        int since = story - p.from * 16, strokes = since * p.strokes, stroke = strokes / p.rows;
        if (p.scene != scene || since < 0 || bar >= p.to || strokes - stroke * p.rows >= p.strokes) continue;
        int size = 0;
        while (p.line[size]) ++size;
        float way = (float)since / (float)((p.to - p.from) * 16);
        strike(m, p.articulation, p.line[stroke % size], chord,
               lerp((float)p.soft, (float)p.loud, way) * 0.01f, (float)p.rows / (float)p.strokes);
    }
    for (const Heard &h : kHeard)
        if (h.scene == scene && h.row == story)
            strike(m, h.articulation, h.tone, chord, (float)h.loud * 0.01f, kRing);
}

} // namespace odraz
