// Tests that the score obeys rules that hold for any good tune, stays within its bars, and fits the pictures.
#include "show/score.h"

#include "show/tune.h"
#include "tests/support/shots.h"

using namespace odraz;

// Returns the notes that begin on a row of the film.
static std::vector<Note> notesOf(int row) {
    auto m = std::make_unique<Mixer>();
    playRow(*m, row);
    std::vector<Note> notes;
    for (int i = 0; i < m->voiceCount; ++i) notes.push_back(m->voices[i].note);
    return notes;
}

// Returns the shot with which the story begins that is heard on a row. Shots that recall an earlier scene do
// not interrupt it.
static const Shot &storyAt(int row) {
    int i = kFilm.count - 1;
    while (kFilm.shots[i].row > (float)row || kFilm.shots[i].row != kFilm.shots[i].storyRow) --i;
    return kFilm.shots[i];
}

// Returns the row of the film on which an event is.
static int rowInFilm(EventId event) { return firstRow(kEvents[event].scene) + kEvents[event].row; }

static int barsOf(int scene) {
    int rows = 0;
    for (int row = 0; row < (int)kFilm.endRow; ++row) rows += storyAt(row).scene == scene;
    return rows / 16;
}

// Returns by how many semitones the music is transposed on a row.
static int upAt(int row) { return row >= rowInFilm(kToneUp) && row < rowInFilm(kWordIsFound) ? 2 : 0; }

// Returns the key of a letter, where D = d'. C is raised over the chord A, C and F in major.
static int keyOf(char letter, char chord) {
    const int steps[] = {57, 58, 60, 62, 64, 65, 67}; // A to G, as capitals
    int key = steps[(letter & 31) - 1] + (letter >= 'a' ? 12 : 0);
    return key + ((letter & 31) == 3 ? chord == 'A' || chord >= 'a' : (letter & 31) == 6 && chord >= 'a');
}

// Returns whether a key is one of the lowest tones of a chord, which is stacked in thirds.
static bool isIn(char chord, int key, int tones) {
    for (int i = 0; i < tones; ++i)
        if ((key - keyOf("ABCDEFG"[((chord & 31) - 1 + 2 * i) % 7], chord)) % 12 == 0) return true;
    return false;
}

static char chordAt(int row) { return kChords[storyAt(row).scene][(row - (int)storyAt(row).storyRow) / 16]; }

static bool isOneOf(const Note &note, std::initializer_list<InstrumentId> all) {
    return std::count(all.begin(), all.end(), note.instrument - kInstruments);
}

// Returns whether piano or voice play the first `beats` tones of a tune from a row on, each for a beat or
// longer.
static bool isTune(int row, const char *tune, int beats) {
    for (int i = 0; i < beats; ++i) {
        if (tune[i] == '-') continue;
        std::vector<Note> notes = notesOf(row + 4 * i);
        int key = keyOf(tune[i], chordAt(row + 4 * i)) + upAt(row + 4 * i);
        if (std::none_of(notes.begin(), notes.end(), [=](const Note &n) {
                return ((int)n.key - key) % 12 == 0 && n.length > 0.49f && isOneOf(n, {kPiano, kVoice});
            }))
            return false;
    }
    return true;
}

constexpr int kWhole = 28; // beats of the tune: its last tone, in the eighth bar, may come later

// Returns the rows of the bars from which the whole tune is played.
static std::vector<int> tunes() {
    std::vector<int> rows;
    for (int row = 0; row + 128 <= (int)kFilm.endRow; row += 16)
        if (isTune(row, kTune, kWhole)) rows.push_back(row);
    return rows;
}

static bool agree(int key, int other) {
    return std::set<int>{0, 3, 4, 5, 7, 8, 9}.count(std::abs(key - other) % 12);
}

// Returns whether tones fit one key: major, or minor, in which the seventh may be raised. Bit 0 is C.
static bool isOneKey(int tones) {
    for (int tonic = 0; tonic < 12; ++tonic) {
        int above = (tones >> tonic | tones << (12 - tonic)) & 4095;
        if (!(above & ~0b101010110101) || !(above & ~0b110110101101)) return true;
    }
    return false;
}

// A tone outside the key of its bars sounds wrong. A key lasts four bars at least, and the film passes
// through four at most. Noise has no tone.
TEST(Score, StaysInAKeyForManyBars) {
    int tones = 0, begins = 0, keys = 1, bars = (int)kFilm.endRow / 16;
    for (int bar = 0; bar < bars; ++bar) {
        int here = 0;
        for (int row = bar * 16; row < bar * 16 + 16; ++row)
            for (const Note &n : notesOf(row)) {
                ASSERT_EQ(n.key, std::floor(n.key));
                EXPECT_TRUE(n.key >= 21 && n.key <= 115) << row; // from the lowest key of a piano, 27.5 Hz
                EXPECT_TRUE(n.velocity > 0 && n.velocity <= 1.15f) << row;
                if (!(n.instrument->noise > 0)) here |= 1 << (int)n.key % 12;
            }
        if (!isOneKey(tones | here)) {
            EXPECT_GE(bar - begins, 4) << "bars of the key before bar " << bar;
            tones = 0, begins = bar, ++keys;
        }
        tones |= here;
    }
    EXPECT_GE(bars - begins, 4);
    EXPECT_LE(keys, 4);
}

TEST(Score, HasAChordForEveryBarOfEveryScene) {
    for (int scene = 0; scene < kSceneCount; ++scene) {
        EXPECT_GT(barsOf(scene), 0) << kScenes[scene].name << " is in no shot";
        EXPECT_EQ((int)std::strlen(kChords[scene]), barsOf(scene)) << kScenes[scene].name;
    }
}

// A listener knows a tune again that was heard whole in the first third.
TEST(Score, PlaysTheWholeTuneEarlyByDayAndInTheFinale) {
    std::vector<int> rows = tunes();
    ASSERT_FALSE(rows.empty());
    EXPECT_LT(rows[0], (int)kFilm.endRow / 3);
    EXPECT_TRUE(std::any_of(rows.begin(), rows.end(), [](int row) {
        return row >= rowInFilm(kPatchesMelt) && row < rowInFilm(kLamp1);
    })) << "by day";
    EXPECT_TRUE(std::count(rows.begin(), rows.end(), rowInFilm(kBall1)));
}

// The tune can be hummed: it spans a tenth, three of four intervals are steps and thirds as in folk songs,
// and leaps are consonant. Bars begin on a tone of their chord. Half bars do too, or they pass to such a tone
// by a step.
TEST(Score, HasATuneThatCanBeHummed) {
    EXPECT_EQ(std::strlen(kTune), 32u) << "eight bars";
    for (int row : tunes()) {
        int low = 200, high = 0, last = 0, leaps = 0, intervals = 0;
        for (int i = 0; i < kWhole; ++i) {
            if (kTune[i] == '-') continue;
            char chord = chordAt(row + 4 * i);
            int key = keyOf(kTune[i], chord);
            low = std::min(low, key), high = std::max(high, key);
            if (int interval = std::abs(key - last); last) {
                ++intervals, leaps += interval > 4;
                EXPECT_TRUE(interval <= 4 || (interval <= 12 && agree(key, last))) << interval;
            }
            last = key;
            if (i % 2) continue;
            int next = keyOf(kTune[i + (i % 4 && kTune[i + 1] != '-')], chord);
            EXPECT_TRUE(isIn(chord, key, 5) || (isIn(chord, next, 5) && std::abs(key - next) <= 2))
                << kTune[i] << " over " << chord;
        }
        EXPECT_LE(high - low, 16);
        EXPECT_LE(4 * leaps, intervals);
    }
}

// kMirrored has the tune's rhythm, and does not rise or fall together with it. In a canon it follows the tune
// some bars later: on bars the two are consonant, and on three of four half bars, or are the dominant's root
// and seventh.
TEST(Score, MirrorsTheTuneInACanon) {
    for (int i = 1, before = 0; i < 32; ++i) {
        ASSERT_EQ(kMirrored[i] == '-', kTune[i] == '-') << i;
        if (kTune[i] == '-') continue;
        int up = stepOf(kTune[i]) - stepOf(kTune[before]),
            other = stepOf(kMirrored[i]) - stepOf(kMirrored[before]);
        EXPECT_LE(up * other, 0) << i;
        before = i;
    }
    auto soundingAt = [](const char *tune, int beat, char chord) {
        while (tune[beat] == '-') --beat;
        return keyOf(tune[beat], chord);
    };
    int canons = 0;
    for (int row : tunes())
        for (int later = 4; later <= 16; later += 4) {
            if (!isTune(row + 4 * later, kMirrored, 32 - later)) continue;
            ++canons;
            int clashes = 0;
            for (int beat = later; beat < 32; beat += 2) {
                char chord = chordAt(row + 4 * beat);
                int upper = soundingAt(kTune, beat, chord),
                    lower = soundingAt(kMirrored, beat - later, chord);
                bool agrees = agree(upper, lower) || (chord == 'A' && lower % 12 == 9);
                EXPECT_TRUE(agrees || beat % 4) << beat << ": " << upper << " over " << lower;
                clashes += !agrees;
            }
            EXPECT_LE(8 * clashes, 32 - later);
        }
    EXPECT_GE(canons, 1);
}

// On a bar the bass plays its chord's root, third or fifth: any other would make it another chord.
TEST(Score, BassBeginsBarsWithTheirChords) {
    for (int row = 0; row < (int)kFilm.endRow; row += 16)
        for (const Note &n : notesOf(row))
            EXPECT_TRUE(!isOneOf(n, {kBass}) || isIn(chordAt(row), (int)n.key - upAt(row), 3))
                << row << ": " << n.key;
}

TEST(Score, IsNarrowestBeforeTheLightAndWidestInTheFinale) {
    auto m = std::make_unique<Mixer>();
    float sum[kSceneCount + 1] = {}, count[kSceneCount + 1] = {}; // by scene; the last is before the light
    for (int row = 0; row < (int)kFilm.endRow; ++row) {
        m->voiceCount = 0;
        playRow(*m, row);
        int scene = storyAt(row).scene, light = rowInFilm(kDirectLight),
            part = scene == kPatches && row < light ? kSceneCount : scene;
        sum[part] += m->crossfeed, ++count[part];
    }
    for (int part = 0; part <= kSceneCount; ++part) {
        float mean = sum[part] / count[part];
        EXPECT_TRUE(part == kSceneCount || mean < sum[kSceneCount] / count[kSceneCount]) << part;
        EXPECT_TRUE(part == kOdraz || mean > sum[kOdraz] / count[kOdraz]) << part;
    }
}

// Each half of the tune swells and fades: the loudest tone is neither its first nor its last, and its tones
// differ by 3 dB.
TEST(Score, PhrasesTheTune) {
    for (int row : tunes())
        for (int half : {0, kAnswer}) {
            float most = 0, least = 2;
            int loudest = 0, last = 0;
            for (int i = half; i < std::min(half + kAnswer, kWhole); ++i) {
                if (kTune[i] == '-') continue;
                float loud = 0;
                for (const Note &n : notesOf(row + 4 * i))
                    if (n.instrument == &kInstruments[kPiano]) loud = std::max(loud, n.velocity);
                if (loud > most) most = loud, loudest = i;
                least = std::min(least, loud), last = i;
            }
            EXPECT_GT(loudest, half) << row;
            EXPECT_LT(loudest, last) << row;
            EXPECT_GT(most, least * 1.4f) << row;
        }
}

// The climax is a tone higher. E minor, to which it rises, is the second step of D major: so when the word is
// found, E minor, A and D major follow without a shift of key. The film ends in D: its lowest tone.
TEST(Score, ClosesFromTheDominantInDMajor) {
    int row = rowInFilm(kWordIsFound), low = 200;
    EXPECT_EQ(chordAt(row - 1), 'D');
    EXPECT_EQ(upAt(row - 1), 2) << "E minor";
    EXPECT_EQ(chordAt(row), 'e');
    EXPECT_EQ(chordAt(row + 16), 'a');
    EXPECT_EQ(row + 32, rowInFilm(kWordShines));
    for (row += 32; row < (int)kFilm.endRow; ++row) {
        EXPECT_EQ(chordAt(row), 'd') << row;
        for (const Note &n : notesOf(row))
            if (!(n.instrument->noise > 0)) low = std::min(low, (int)n.key);
    }
    EXPECT_EQ(low % 12, 2);
}

TEST(Score, NeverBeginsTooManyNotesAtOnce) {
    for (int row = 0; row < (int)kFilm.endRow; ++row)
        EXPECT_LE((int)notesOf(row).size(), kVoicesAtOnce) << row;
    EXPECT_TRUE(notesOf((int)kFilm.endRow).empty());
    EXPECT_TRUE(notesOf((int)kFilm.endRow + 1000).empty());
}

TEST(Score, HasASoundOnEveryCutAndEveryHeardEvent) {
    for (int i = 1; i < kFilm.count; ++i) {
        int row = (int)kFilm.shots[i].row;
        EXPECT_TRUE(!notesOf(row).empty() || row == rowInFilm(kHallIsBlack))
            << i << ": no sound, no dead stop";
    }
    for (const Event &e : kEvents)
        if (e.heard) {
            EXPECT_FALSE(notesOf(rowInFilm(e.id)).empty()) << (int)e.id;
        }
}

// Each strip sounds a tone of the piano, a step of the scale above the tone before. (The last is in a chord,
// in any octave.)
TEST(Score, ClimbsAScaleWithTheStrips) {
    std::set<int> last;
    for (int i = kStrip1; i <= kStrip8; ++i) {
        std::set<int> next;
        for (const Note &n : notesOf(rowInFilm((EventId)i)))
            if (n.instrument == &kInstruments[kPiano] &&
                (i == kStrip1 || std::any_of(last.begin(), last.end(), [&](int key) {
                     int up = (int)n.key - key;
                     if (i == kStrip8) up = (up + 120) % 12;
                     return up == 1 || up == 2;
                 })))
                next.insert((int)n.key);
        EXPECT_FALSE(next.empty()) << "strip " << i - kStrip1 + 1;
        last = next;
    }
}

// They go out as the same scale backwards, bare: no other instrument begins a tone.
TEST(Score, DescendsTheScaleBareWhileTheStripsGoOut) {
    int last = 0;
    for (int i = 0; i < 8; ++i) {
        std::vector<Note> notes = notesOf(rowInFilm(kDoorDies) + 4 * i);
        notes.erase(
            std::remove_if(notes.begin(), notes.end(), [](const Note &n) { return n.instrument->noise > 0; }),
            notes.end());
        ASSERT_EQ(notes.size(), 1u) << i;
        int key = (int)notes[0].key;
        EXPECT_TRUE(i == 0 || last - key == 1 || last - key == 2) << i;
        last = key;
    }
}

// (music_test tests that these rows are silent.)
TEST(Score, IsMutedBeforeTheHitsAndNowhereElse) {
    auto m = std::make_unique<Mixer>();
    int muted = 0, silent = 0;
    for (int row = 0; row < (int)kFilm.endRow; ++row) m->voiceCount = 0, playRow(*m, row), muted += m->muted;
    for (const Silence &silence : kSilences) silent += silence.rows;
    EXPECT_EQ(muted, silent);
}

// The drum beats on the first and third beat, then, a tone up, on all four until the summit ends. Every
// fourth bar has a fill: strokes of the brush that are on no beat.
TEST(Score, BeatsOnAllFourFromTheToneUp) {
    for (int row = rowInFilm(kBall1); row < rowInFilm(kDoorDies); ++row) {
        bool drum = false;
        for (const Note &n : notesOf(row)) drum |= isOneOf(n, {kDrum});
        EXPECT_EQ(drum, row % (row < rowInFilm(kToneUp) ? 8 : 4) == 0) << row;
    }
    for (int bar = rowInFilm(kBall1) / 16; bar < rowInFilm(kRecall) / 16; ++bar) {
        int off = 0;
        for (int row = bar * 16; row < bar * 16 + 16; ++row)
            for (const Note &n : notesOf(row)) off += row % 4 && isOneOf(n, {kBrush});
        EXPECT_EQ(off > 0, bar % 4 == 3) << bar;
    }
}

// When the point of light enters a set, its four tones sound on glass, on the right. Within two beats its
// image begins to answer, backwards, softer and on the left.
TEST(Score, PlaysTheCellWhereThePointEnters) {
    // The bars, and the rows between tones
    const int entrances[][2] = {{2, 4},  {6, 2},  {16, 2}, {28, 2}, {36, 2},
                                {45, 2}, {49, 2}, {56, 4}, {72, 2}};
    const int cell[] = {69, 74, 76, 81}; // a' d" e" a"
    for (auto [bar, step] : entrances) {
        std::vector<Note> heard, answer;
        std::vector<int> rows[2];
        for (int row = bar * 16; row < bar * 16 + 32; ++row)
            for (const Note &n : notesOf(row))
                if (isOneOf(n, {kGlassDrop}) && n.left != 0 && std::count(cell, cell + 4, (int)n.key)) {
                    (n.left < 0 ? heard : answer).push_back(n);
                    rows[n.left > 0].push_back(row);
                }
        ASSERT_GE(heard.size(), 4u) << bar;
        ASSERT_GE(answer.size(), 4u) << bar;
        for (int i = 0; i < 4; ++i) {
            EXPECT_EQ((int)heard[(size_t)i].key, cell[i]) << bar;
            EXPECT_EQ((int)answer[(size_t)i].key, cell[3 - i]) << bar;
            EXPECT_LT(answer[(size_t)i].velocity, heard[(size_t)i].velocity) << bar;
        }
        EXPECT_EQ(rows[0][3] - rows[0][0], 3 * step) << bar;
        EXPECT_EQ(rows[1][0] - rows[0][0], 4) << bar << ": a beat later";
    }
}

// The last sound is the answer to a ping that is not heard.
TEST(Score, EndsWithAnAnswerAlone) {
    for (int row = rowInFilm(kLastAnswer) - 8; row < (int)kFilm.endRow; ++row) {
        std::vector<Note> notes = notesOf(row);
        ASSERT_EQ(notes.size(), row == rowInFilm(kLastAnswer) ? 1u : 0u) << row;
        if (notes.empty()) continue;
        EXPECT_GT(notes[0].left, 0);
        std::vector<Note> first = notesOf(4);
        EXPECT_TRUE(std::any_of(first.begin(), first.end(), [&](const Note &n) {
            return n.instrument == notes[0].instrument && n.key == notes[0].key && n.left == notes[0].left;
        })) << "the film's first answer";
    }
}
