// The score stays within its scale and its bars, and fits the pictures.
#include "show/score.h"

#include "show/show.h"

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

int firstRow(SceneId scene) {
    for (int i = 0; i < kFilm.count; ++i)
        if (kFilm.shots[i].scene == scene) return (int)kFilm.shots[i].storyRow;
    return -1;
}

} // namespace

TEST(Score, KeepsToItsScale) {
    int count = 0;
    for (int row = 0; row < (int)kFilm.endRow; ++row)
        for (const Note &n : notesOf(row)) {
            bool major = row >= firstRow(kCredits);
            std::set<int> scale =
                major ? std::set<int>{1, 2, 4, 6, 7, 9, 11} : std::set<int>{0, 2, 4, 5, 7, 9, 10};
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
        float rows = 0;
        for (int i = 0; i < kFilm.count; ++i) {
            const Shot &shot = kFilm.shots[i];
            if (shot.scene == scene)
                rows = (i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow) - shot.storyRow;
        }
        EXPECT_GT(rows, 0) << kScenes[scene].name << " is in no shot";
        EXPECT_EQ((float)std::strlen(kChords[scene]), rows / (float)kRowsPerBar) << kScenes[scene].name;
    }
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

TEST(Events, StandInTheirScenesInOrder) {
    for (const Event &e : kEvents) {
        float from = -1, to = 0;
        for (int i = 0; i < kFilm.count; ++i)
            if (kFilm.shots[i].scene == e.scene) {
                if (from < 0) from = kFilm.shots[i].storyRow;
                to = i + 1 < kFilm.count ? kFilm.shots[i + 1].row : kFilm.endRow;
            }
        EXPECT_GE(e.row, 0) << (int)e.id;
        EXPECT_LT(from + (float)e.row, to) << (int)e.id;
    }
}
