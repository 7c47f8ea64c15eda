// The score stays within its scale and its bars, and fits the pictures.
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

// The notes that begin on a row of the film.
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

// The key of a letter of the tune, from D = d' on; `chord` may raise C.
int keyOf(char letter, char chord) {
    const int steps[] = {57, 58, 60, 62, 64, 65, 67}; // A to G, as capitals
    int key = steps[(letter & 31) - 1] + (letter >= 'a' ? 12 : 0);
    return key + (chord == 'A' && (letter & 31) == 3);
}

char chordAt(int row) {
    Moment m = momentAt(kFilm, row);
    return kChords[m.shot->scene][(int)m.storyRow / 16];
}

// Whether one of some instruments plays a key, in any octave, from a row on.
bool isPlayed(int row, int key, std::initializer_list<InstrumentId> by, float least = 0) {
    std::vector<Note> notes = notesOf(row);
    return std::any_of(notes.begin(), notes.end(), [&](const Note &n) {
        return (int)n.key % 12 == key % 12 && n.length >= least &&
               std::count(by.begin(), by.end(), n.instrument - kInstruments);
    });
}

// The number of beats of the tune, counted from the beat `from`, that are not played from a row on.
int missing(int row, int from, int beats) {
    int count = 0;
    for (int i = 0; i < beats; ++i)
        if (char letter = kTune[from + i]; letter != '-')
            count += !isPlayed(row + 4 * i, keyOf(letter, chordAt(row + 4 * i)), {kPiano, kVoice}, 0.49f);
    return count;
}

} // namespace

TEST(Score, KeepsToItsScale) {
    int count = 0;
    for (int row = 0; row < (int)kFilm.endRow; ++row)
        for (const Note &n : notesOf(row)) {
            bool major = row >= firstRow(kCredits);
            std::set<int> scale =
                major ? std::set<int>{1, 2, 4, 6, 7, 9, 11} : std::set<int>{0, 2, 4, 5, 7, 9, 10};
            if (chordAt(row) == 'A') scale.erase(0), scale.insert(1); // the dominant has the leading tone
            ASSERT_EQ(n.key, std::floor(n.key));
            EXPECT_TRUE(scale.count((int)n.key % 12)) << row << ": " << n.key;
            EXPECT_GE(n.key, 24) << row; // 33 Hz
            EXPECT_LE(n.key, 115) << row;
            EXPECT_TRUE(n.velocity > 0 && n.velocity <= 1.1f) << row;
            ++count;
        }
    std::printf("%d notes\n", count);
    EXPECT_GT(count, 500);
}

TEST(Score, HasAChordForEveryBarOfEveryScene) {
    for (int scene = 0; scene < kSceneCount; ++scene) {
        EXPECT_GT(barsOf(scene), 0) << kScenes[scene].name << " is in no shot";
        // Scene 4 may end earlier, and the day, whose chords count from its end, may then begin earlier
        int bars = (int)std::strlen(kChords[scene]);
        EXPECT_GE(bars, barsOf(scene)) << kScenes[scene].name;
        EXPECT_TRUE(bars == barsOf(scene) || scene == kPatches)
            << kScenes[scene].name << ": kDayBegins in music.h?";
    }
}

TEST(Score, StatesTheTuneWhereItIsPromised) {
    EXPECT_EQ(std::strlen(kTune), 32u) << "eight bars";
    int door = firstRow(kHall) + barsOf(kHall) * 16;
    EXPECT_EQ(missing(firstRow(kTable), 0, 32), 0) << "at the table";
    EXPECT_EQ(missing(firstRow(kTable) + 128, kAnswer, 16), 0) << "and its answer";
    EXPECT_EQ(missing(door - 256, 0, 24), 0) << "remembered in the hall, and broken off";
    EXPECT_EQ(missing(door - 128, 0, 28), 0) << "whole at the door: its last tone is the finale's first";
    EXPECT_EQ(missing(firstRow(kOdraz), 0, 32), 0) << "in the finale";
    EXPECT_EQ(missing(firstRow(kOdraz) + 128, kAnswer, 8), 0) << "and its answer, slower and slower";
    const int at[] = {kEvents[kLine1].row, kEvents[kLine2].row, kEvents[kLine2].row + 4};
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(isPlayed(firstRow(kCredits) + at[i], keyOf("DaG"[i], 'd'), {kGlassDrop})) << i;
}

// It can be sung: within a tenth, in steps but for thirds and two leaps up. Every bar begins on a tone of its
// chord; so does every half bar, or it passes to one by a step.
TEST(Score, HasATuneToSing) {
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

TEST(Score, AddsNoMoreNotesAtOnceThanFit) {
    for (int row = 0; row < (int)kFilm.endRow; ++row)
        EXPECT_LE((int)notesOf(row).size(), kVoicesAtOnce) << row;
    EXPECT_TRUE(notesOf((int)kFilm.endRow).empty());
    EXPECT_TRUE(notesOf((int)kFilm.endRow + 1000).empty());
}

TEST(Score, HasASoundOnEveryCutAndEveryEventThatIsHeard) {
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
        float key = 0; // the event's sound is played last
        for (const Note &n : notes)
            if (n.instrument == &kInstruments[kPiano]) key = n.key;
        if (i < kStrip8) {
            EXPECT_GT(key, last);
            last = key;
        }
    }
}
