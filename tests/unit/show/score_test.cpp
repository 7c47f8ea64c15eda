// Tests that the score stays within its scale and its bars, and fits the pictures.
#include "show/score.h"

#include "show/tune.h"
#include "tests/support/shots.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <set>

using namespace odraz;

namespace {

// Returns the notes that begin on a row of the film.
std::vector<Note> notesOf(int row) {
    auto m = std::make_unique<Mixer>();
    playRow(*m, row);
    std::vector<Note> notes;
    for (int i = 0; i < m->voiceCount; ++i) notes.push_back(m->voices[i].note);
    return notes;
}

int barsOf(int scene) {
    float rows = 0;
    for (int i = 0; i < kFilm.count; ++i)
        if (kFilm.shots[i].scene == scene) rows = endOf(i) - kFilm.shots[i].storyRow;
    return (int)rows / 16;
}

// Returns the key of a letter of the tune, where D = d'. `chord` A raises C.
int keyOf(char letter, char chord) {
    const int steps[] = {57, 58, 60, 62, 64, 65, 67}; // A to G, as capitals
    int key = steps[(letter & 31) - 1] + (letter >= 'a' ? 12 : 0);
    return key + (chord == 'A' && (letter & 31) == 3);
}

char chordAt(int row) {
    Moment m = momentAt(kFilm, row);
    return kChords[m.shot->scene][(int)m.storyRow / 16];
}

// Returns whether one of the instruments `by` plays a key, in any octave, on a row. `least`: minimum length.
bool isPlayed(int row, int key, std::initializer_list<InstrumentId> by, float least = 0) {
    std::vector<Note> notes = notesOf(row);
    return std::any_of(notes.begin(), notes.end(), [&](const Note &n) {
        return (int)n.key % 12 == key % 12 && n.length >= least &&
               std::count(by.begin(), by.end(), n.instrument - kInstruments);
    });
}

// Returns the number of a tune's tones that are not played from a row on. `beat`: rows a beat.
int missing(int row, const char *tune, int beats, int beat = 4) {
    int count = 0;
    for (int i = 0; i < beats; ++i)
        if (int at = row + beat * i; tune[i] != '-')
            count += !isPlayed(at, keyOf(tune[i], chordAt(at)), {kPiano, kVoice}, 0.124f * (float)beat);
    return count;
}

} // namespace

TEST(Score, StaysInItsScale) {
    int count = 0;
    for (int row = 0; row < (int)kFilm.endRow; ++row)
        for (const Note &n : notesOf(row)) {
            bool major = row >= firstRow(kCredits);
            std::set<int> scale =
                major ? std::set<int>{1, 2, 4, 6, 7, 9, 11} : std::set<int>{0, 2, 4, 5, 7, 9, 10};
            if (chordAt(row) == 'A') scale.erase(0), scale.insert(1); // the dominant has the leading tone
            ASSERT_EQ(n.key, std::floor(n.key));
            EXPECT_TRUE(scale.count((int)n.key % 12)) << row << ": " << n.key;
            EXPECT_GE(n.key, 21) << row; // 27.5 Hz: the lowest key of a piano
            EXPECT_LE(n.key, 115) << row;
            EXPECT_TRUE(n.velocity > 0 && n.velocity <= 1.15f) << row;
            ++count;
        }
    std::printf("%d notes\n", count);
    EXPECT_GT(count, 500);
}

TEST(Score, HasAChordForEveryBarOfEveryScene) {
    for (int scene = 0; scene < kSceneCount; ++scene) {
        EXPECT_GT(barsOf(scene), 0) << kScenes[scene].name << " is in no shot";
        // kPatches may end earlier: then the day begins earlier, and its chords count from its end
        int bars = (int)std::strlen(kChords[scene]);
        EXPECT_GE(bars, barsOf(scene)) << kScenes[scene].name;
        EXPECT_TRUE(bars == barsOf(scene) || scene == kPatches)
            << kScenes[scene].name << ": kDayBegins in music.h?";
    }
}

TEST(Score, PlaysTheTuneInItsScenes) {
    EXPECT_EQ(std::strlen(kTune), 32u) << "eight bars";
    int door = firstRow(kHall) + barsOf(kHall) * 16;
    EXPECT_EQ(missing(firstRow(kTable), kTune, 32), 0) << "at the table";
    EXPECT_EQ(missing(firstRow(kTable) + 128, kTune + kAnswer, 16), 0) << "and its answer";
    EXPECT_EQ(missing(firstRow(kFlake), kMirrored, 16), 0) << "its mirror image, as the flake grows";
    EXPECT_EQ(missing(firstRow(kFlake) + 64, kTune, 16, 8), 0) << "half of it, half as fast";
    EXPECT_EQ(missing(firstRow(kHall) - 64, kMirrored, 16), 0) << "its mirror image, in the light";
    EXPECT_EQ(missing(door - 256, kTune, 24), 0) << "remembered in the hall, and broken off";
    EXPECT_EQ(missing(door - 160, kMirrored + 24, 8), 0) << "and ended by its mirror image";
    EXPECT_EQ(missing(door - 128, kTune, 28), 0) << "whole at the door: its last tone is the finale's first";
    EXPECT_EQ(missing(firstRow(kOdraz), kTune, 32), 0) << "in the finale";
    EXPECT_EQ(missing(firstRow(kOdraz) + 32, kMirrored, 24), 0) << "followed by its mirror image";
    EXPECT_EQ(missing(firstRow(kOdraz) + 128, kTune + kAnswer, 8), 0) << "and its answer, slower and slower";
    const int at[] = {kEvents[kLine1].row, kEvents[kLine2].row, kEvents[kLine2].row + 4};
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(isPlayed(firstRow(kCredits) + at[i], keyOf("DaG"[i], 'd'), {kGlassDrop})) << i;
}

// The tune can be sung: it spans a tenth, in steps and thirds, with two leaps up. Bars begin on a tone of
// their chord. Half bars do too, or they pass to such a tone by a step.
TEST(Score, HasATuneThatCanBeSung) {
    int low = 200, high = 0, last = 0, leaps = 0;
    for (int i = 0; i < 32; ++i) {
        if (kTune[i] == '-') continue;
        int key = keyOf(kTune[i], kChords[kTable][i / 4]);
        low = std::min(low, key), high = std::max(high, key);
        if (last) leaps += std::abs(key - last) > 4;
        last = key;
    }
    EXPECT_GE(low, 55);
    EXPECT_LE(high - low, 16);
    EXPECT_EQ(leaps, 2) << "a fifth, and an octave";
    for (auto [row, bars] : {std::pair(firstRow(kTable), 8),
                             {firstRow(kOdraz), 8},
                             {firstRow(kHall) + barsOf(kHall) * 16 - 128, 7}})
        for (int i = 0; i < bars * 4; i += 2) {
            if (kTune[i] == '-') continue;
            char chord = chordAt(row + 4 * i);
            auto fits = [&](int i) {
                for (int third = 0; third < 5; ++third)
                    if ((kTune[i] & 31) == (chord - 'A' + 2 * third) % 7 + 1) return true;
                return false;
            };
            bool passes =
                i % 4 && fits(i + 1) && std::abs(keyOf(kTune[i], chord) - keyOf(kTune[i + 1], chord)) <= 2;
            EXPECT_TRUE(fits(i) || passes) << kTune[i] << " over " << chord;
        }
}

// kMirrored mirrors each tone of the tune about F, except two that would clash. In the finale it follows the
// tune two bars later. On every half bar except one, the two are consonant or are the dominant's root and
// seventh.
TEST(Score, MirrorsTheTuneInACanon) {
    int others = 0;
    for (int i = 0; i < 32; ++i) {
        EXPECT_EQ(kMirrored[i] == '-', kTune[i] == '-') << i;
        auto step = [](char letter) { return (letter & 31) - 'F' % 32 + (letter < 'a' ? 0 : 7); };
        if (kTune[i] != '-') others += step(kMirrored[i]) != -step(kTune[i]);
    }
    EXPECT_EQ(others, 2);
    auto soundingAt = [](const char *tune, int beat) {
        while (tune[beat] == '-') --beat;
        return tune[beat];
    };
    int passing = 0;
    for (int beat = 8; beat < 32; beat += 2) {
        char upper = soundingAt(kTune, beat), lower = soundingAt(kMirrored, beat - 8),
             chord = chordAt(firstRow(kOdraz) + 4 * beat);
        int interval = (keyOf(upper, chord) - keyOf(lower, chord) + 24) % 12;
        bool agree = std::set<int>{0, 3, 4, 5, 7, 8, 9}.count(interval) || (chord == 'A' && lower == 'a');
        EXPECT_TRUE(agree || beat % 4) << beat << ": " << upper << " over " << lower;
        passing += !agree;
    }
    EXPECT_LE(passing, 1);
}

// While the flake grows, the piano plays against the tune, which is half as fast: few notes, in steps and
// thirds, consonant with the tune on every half bar.
TEST(Score, HasACounterTuneInTheGrowth) {
    int from = firstRow(kFlake) + 64, key = 0, low = 200, high = 0, count = 0;
    char upper = 0;
    for (int row = 0; row < 128; row += 4) {
        for (const Note &n : notesOf(from + row))
            if (n.instrument == &kInstruments[kPiano]) {
                EXPECT_LE(std::abs((int)n.key - (key ? key : (int)n.key)), 4) << row;
                key = (int)n.key, low = std::min(low, key), high = std::max(high, key), ++count;
            }
        if (row % 8) continue;
        if (kTune[row / 8] != '-') upper = kTune[row / 8];
        int interval = (key - keyOf(upper, chordAt(from + row)) + 24) % 12;
        EXPECT_TRUE((std::set<int>{0, 3, 4, 5, 7, 8, 9}.count(interval)))
            << row << ": " << key << " over " << upper;
    }
    EXPECT_LE(high - low, 12);
    EXPECT_LE(count, 20);
}

TEST(Score, IsNarrowInDryScenesAndWidestInTheFinale) {
    auto m = std::make_unique<Mixer>();
    std::vector<float> at;
    for (int row = 0; row < (int)kFilm.endRow; ++row) {
        m->voiceCount = 0;
        playRow(*m, row);
        at.push_back(m->crossfeed);
    }
    auto in = [&](SceneId scene, int row) { return at[(size_t)(firstRow(scene) + row)]; };
    EXPECT_GT(in(kPatches, 0), 0.3f) << "at once, after a silence";
    EXPECT_LT(in(kPatches, kEvents[kDirectLight].row), 0.2f);
    EXPECT_GT(in(kTable, 96), 0.2f);
    EXPECT_LT(in(kHall, 96), 0.15f);
    EXPECT_LT(in(kOdraz, 0), 0.08f);
}

// Each half of the tune swells to its second bar, with uneven velocities.
TEST(Score, IsPhrased) {
    for (int half : {0, 16}) {
        float most = 0, least = 2;
        int loudest = 0;
        for (int i = half; i < half + 16; ++i)
            for (const Note &n : notesOf(firstRow(kTable) + 4 * i))
                if (n.instrument == &kInstruments[kPiano]) {
                    if (n.velocity > most) most = n.velocity, loudest = i;
                    least = std::min(least, n.velocity);
                }
        EXPECT_EQ(loudest, half + 4);
        EXPECT_GT(most, least * 1.4f) << "3 dB";
    }
}

TEST(Score, ClosesFromTheDominantAndEndsOnTheMajorNinth) {
    for (auto [row, tonic] :
         {std::pair{firstRow(kTable) + 7 * 16, 'D'}, {firstRow(kOdraz), 'D'}, {firstRow(kCredits), 'd'}}) {
        EXPECT_EQ(chordAt(row - 1), 'A');
        EXPECT_EQ(chordAt(row), tonic);
    }
    int last = 0;
    for (int row = 0; row < (int)kFilm.endRow; ++row)
        for (const Note &n : notesOf(row))
            if (n.instrument == &kInstruments[kGlassDrop]) last = (int)n.key;
    EXPECT_EQ(last % 12, 4);
}

TEST(Score, NeverBeginsTooManyNotesAtOnce) {
    for (int row = 0; row < (int)kFilm.endRow; ++row)
        EXPECT_LE((int)notesOf(row).size(), kVoicesAtOnce) << row;
    EXPECT_TRUE(notesOf((int)kFilm.endRow).empty());
    EXPECT_TRUE(notesOf((int)kFilm.endRow + 1000).empty());
}

TEST(Score, HasASoundOnEveryCutAndEveryHeardEvent) {
    for (int i = 1; i < kFilm.count; ++i) EXPECT_FALSE(notesOf((int)kFilm.shots[i].row).empty()) << i;
    for (const Event &e : kEvents)
        if (e.heard) {
            EXPECT_FALSE(notesOf(firstRow(e.scene) + e.row).empty()) << (int)e.id;
        }
}

TEST(Score, ClimbsAScaleWithTheStrips) {
    float last = 0;
    for (int i = kStrip1; i <= kStrip8; ++i) {
        std::vector<Note> notes = notesOf(firstRow(kHall) + kEvents[i].row);
        float key = 0; // the event's sound is the last one
        for (const Note &n : notes)
            if (n.instrument == &kInstruments[kPiano]) key = n.key;
        if (i < kStrip8) {
            EXPECT_GT(key, last);
            last = key;
        }
    }
}
