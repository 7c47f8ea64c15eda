#include "show/score.h"

#include "show/music.h"
#include "show/show.h"

namespace odraz {

namespace {

constexpr float kRing = 16; // rows that the sound of an event lasts

static_assert(sizeof kChords / sizeof *kChords == kSceneCount);
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

constexpr bool hasSound(const Event &event) {
    for (const EventSound &sound : kEventSounds)
        if (sound.scene == event.scene && sound.row == event.row) return true;
    return false;
}
static_assert(
    [] {
        for (const Event &e : kEvents)
            if (e.heard != hasSound(e)) return false;
        return true;
    }(),
    "what is marked as heard has a sound, and nothing else has");

void strike(Mixer &m, const Articulation &articulation, char tone, char chord, float velocity, float rows) {
    static constexpr int8_t kMinor[] = {0, 2, 3, 5, 7, 8, 10}, kMajor[] = {0, 2, 4, 5, 7, 9, 11};
    if (tone < '0') return;
    int root = stepOf((char)(chord & ~32));
    int step = tone < 'A' ? root + 2 * (tone - '0') : stepOf(tone);
    for (int i = 0; i < articulation.stack; ++i) {
        int at = step + 2 * i + 70, degree = at % 7;
        // A chord's tones keep to their octaves: from chord to chord they stand or move by a step or two
        if (articulation.stack > 1) at = 70 + degree + ((i & 1) + i / 4) * 7;
        const int8_t *scale = chord < 'a' ? kMinor : kMajor;
        int leading = chord == 'A' && degree == 6;
        float key = (float)(12 * (at / 7 - 10 + articulation.octave) + scale[degree] + leading + 14);
        playNote(m, {&kInstruments[articulation.instrument], key, velocity, rows * 0.125f,
                     (float)articulation.room * 0.01f, (float)articulation.left * 0.01f});
    }
}

bool isHit(int row) {
    Moment then = momentAt(kFilm, row);
    for (EventId hit : kHits)
        if (kEvents[hit].scene == then.shot->scene && kEvents[hit].row == (int)then.storyRow) return true;
    return false;
}

} // namespace

void playRow(Mixer &m, int row) {
    if (row >= (int)kFilm.endRow) return;
    m.hushed = isHit(row + 1) || isHit(row + 2);
    Moment now = momentAt(kFilm, row);
    int scene = now.shot->scene, story = (int)now.storyRow, bar = story / 16;
    char chord = kChords[scene][bar];
    m.narrow = lerp(m.narrow, (float)narrowAt(scene, bar) * 0.01f, isHit(row) ? 1 : 0.02f);
    for (const Part &p : kParts) {
        int since = story - p.from * 16, strokes = since * p.strokes, stroke = strokes / p.rows;
        if (p.scene != scene || since < 0 || bar >= p.to || strokes - stroke * p.rows >= p.strokes) continue;
        int size = 0, held = 1;
        while (p.line[size]) ++size;
        const char *tone = &p.line[stroke % size];
        while (tone[held] == '-') ++held;
        // Metre, and an arch over four bars, which is highest after a third of them
        float way = (float)since / (float)((p.to - p.from) * 16), x = (float)(since & 63) * (1.f / 64);
        float phrased =
            1 - (float)((story % 16 > 0) + (story % 8 > 0)) * 0.16f + x * (1 - x) * (1 - x) * 1.8f;
        strike(m, p.articulation, *tone, chord, lerp((float)p.soft, (float)p.loud, way) * 0.01f * phrased,
               (float)(p.rows * held) / (float)p.strokes);
    }
    for (const EventSound &sound : kEventSounds)
        if (sound.scene == scene && sound.row == story)
            strike(m, sound.articulation, sound.tone, chord, (float)sound.loud * 0.01f, kRing);
}

} // namespace odraz
