#include "show/score.h"

#include "show/music.h"
#include "show/show.h"

namespace odraz {

namespace {

constexpr float kRing = 16; // length of an event's sound, rows

static_assert(
    [] {
        for (const Part &p : kParts)
            if (!kChords[p.scene]) return false;
        return true;
    }(),
    "every scene with parts has chords in kChords");
static_assert(
    [] {
        for (const Part &p : kParts) {
            int bars = 0;
            while (kChords[p.scene] && kChords[p.scene][bars]) ++bars;
            if (p.bars[0] >= p.bars[1] || p.bars[1] > bars) return false;
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
    "events marked as heard have a sound, and no others");

void strike(Mixer &m, const Articulation &articulation, char tone, char chord, int up, float velocity,
            float rows) {
    static constexpr int8_t kMinor[] = {0, 2, 3, 5, 7, 8, 10}, kMajor[] = {0, 2, 4, 5, 7, 9, 11};
    if (tone < '0') return;
    int root = stepOf((char)(chord & ~32));
    int step = tone < 'A' ? root + 2 * (tone - '0') : stepOf(tone);
    for (int i = 0; i < articulation.stack; ++i) {
        int at = step + 2 * i + 70, degree = at % 7;
        // Keep a chord's tones in fixed octaves: from chord to chord they stay or move by a step or two
        if (articulation.stack > 1) at = 70 + degree + ((i & 1) + i / 4) * 7;
        const int8_t *scale = chord < 'a' ? kMinor : kMajor;
        int leading = chord == 'A' && degree == 6;
        float key = (float)(12 * (at / 7 - 10 + articulation.octave) + scale[degree] + leading + 14 + up);
        playNote(m, {&kInstruments[articulation.instrument], key, velocity, rows * 0.125f,
                     (float)articulation.room * 0.01f, (float)articulation.left * 0.01f});
    }
}

// Returns the scene whose story plays on a row. A shot that shows a moment of an earlier scene does not begin
// a story.
const Shot &storyAt(int row) {
    int i = kFilm.count - 1;
    while (i > 0 && (kFilm.shots[i].row > row || kFilm.shots[i].row != kFilm.shots[i].storyRow)) --i;
    return kFilm.shots[i];
}

bool isSilent(int row) {
    for (const Silence &s : kSilences)
        for (int after = row + 1; after <= row + s.rows; ++after) {
            const Shot &story = storyAt(after);
            if (s.scene == story.scene && s.before == after - (int)story.storyRow) return true;
        }
    return false;
}

} // namespace

void playRow(Mixer &m, int row) {
    if (row >= (int)kFilm.endRow) return;
    bool silent = m.muted;
    m.muted = isSilent(row);
    // The level rises at once, falls within a beat, and fades out over the film's last beat
    float level = row + 4 < (int)kFilm.endRow ? kLevels[row / 16] : -40;
    m.level = max(level, lerp(m.level, level, 0.5f));
    const Shot &now = storyAt(row);
    int scene = now.scene, story = row - (int)now.storyRow, bar = story / 16, up = semitonesUpAt(scene, bar);
    char chord = kChords[scene][bar];
    m.crossfeed = lerp(m.crossfeed, (float)crossfeedAt(scene, bar) * 0.01f, silent ? 1 : 0.02f);
    for (const Part &p : kParts) {
        const auto &[from, to] = p.bars;
        const auto &[count, rows] = p.strokes;
        int since = story - from * 16, strokes = since * count, stroke = strokes / rows;
        if (p.scene != scene || since < 0 || bar >= to || strokes - stroke * rows >= count) continue;
        int size = 0, held = 1;
        while (p.line[size]) ++size;
        const char *tone = &p.line[stroke % size];
        while (tone[held] == '-') ++held;
        // Apply the metre, and an arch over four bars, which is highest after a third of them
        float progress = (float)since / (float)((to - from) * 16), x = (float)(since & 63) * (1.f / 64);
        float phrased =
            1 - (float)((story % 16 > 0) + (story % 8 > 0)) * 0.16f + x * (1 - x) * (1 - x) * 1.8f;
        float velocity = lerp((float)p.velocity[0], (float)p.velocity[1], progress) * 0.01f * phrased;
        strike(m, p.sound, *tone, chord, up, velocity, (float)(rows * held) / (float)count);
    }
    for (const EventSound &sound : kEventSounds)
        if (sound.scene == scene && sound.row == story)
            strike(m, sound.articulation, sound.tone, chord, up, (float)sound.velocity * 0.01f, kRing);
}

} // namespace odraz
