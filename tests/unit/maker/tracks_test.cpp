#include "maker/keys/key_file.h"
#include "maker/tracks.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"

using namespace odraz;
using namespace odraz::maker;

// A film of two scenes: the first has a camera's path and a track, the second a track whose rows count from
// row 4.
constexpr char kFilmKeys[] = R"(PATH(kPath, 24)
    {-8, {1, 2, 3}, {4, 5, 6}, 7, 40},
    {16, {2, 3, 4}, {5, 6, 7}, 8, 50},
END
PATH(kOther, 24)
    {0, {1, 2, 3}, {4, 5, 6}, 7, 40},
END
)";
constexpr char kStartKeys[] = R"(TRACK(kLamp)
    {0, 1, Linear},
    {2.5, 2, Smooth},
    {8, 3, Linear},
END
)";
constexpr char kEndKeys[] = "TRACK(kGrow, rowOf(kSprouts))\n    {0, 0, Linear},\n    {4, 1, Linear},\nEND\n";
static KeyTable kPath = {
    "kPath", "./show/film.keys", 24, {{-8, {1, 2, 3}, {4, 5, 6}, 7, 40}, {16, {2, 3, 4}, {5, 6, 7}, 8, 50}}};
static KeyTable kOther = {"kOther", "./show/film.keys", 24, {{0, {1, 2, 3}, {4, 5, 6}, 7, 40}}};
using enum odraz::Interpolation;
static KeyTable kLamp = {
    "kLamp", "./show/scenes/start.keys", 0.f, {{0, 1, Linear}, {2.5f, 2, Smooth}, {8, 3, Linear}}};
static KeyTable kGrow = {"kGrow", "./show/scenes/end.keys", 4.f, {{0, 0, Linear}, {4, 1, Linear}}};

static CameraPath thePaths[2];
static double theCut = 1e9; // where the second scene begins, in seconds
static int shots(ShotInfo *to, int) {
    to[0] = {0, theCut, 0, 0, &thePaths[0]};
    to[1] = {theCut, 2e9, 100 / kRowsPerSecond, 1, &thePaths[1]};
    return 2;
}
static int events(EventInfo *to, int) {
    to[0] = {13, 4, true, "kSprouts"};
    return 1;
}
static void setKeys(KeyTable &table, const void *keys, int count) {
    std::memcpy(table.keys, keys, (size_t)count * (table.camera ? sizeof(CameraKey) : sizeof(odraz::Key)));
    table.count = count;
}
static Inspector theInspector = {};

// The keys that the film is shown with.
static std::vector<KeyNumbers> keysOf(const KeyTable &t) {
    std::vector<KeyNumbers> all;
    for (int i = 0; i < t.count; ++i) all.push_back(t.camera ? numbersOf(t.poses[i]) : numbersOf(t.keys[i]));
    return all;
}
using Keys = std::vector<KeyNumbers>;

struct Fixture : testing::Test {
    common::TemporaryFolder folder;
    Live live = {};
    Tracks tracks{folder / ""};
    std::string message;

    Fixture() {
        std::filesystem::create_directory(folder / "scenes");
        write("film.keys", kFilmKeys);
        write("scenes/start.keys", kStartKeys);
        write("scenes/end.keys", kEndKeys);
        theCut = 1e9;
        thePaths[0] = path(kPath), thePaths[1] = path(kOther);
        live.sceneName = [](int scene) { return scene ? "end" : "start"; };
        live.setKeys = setKeys;
        theInspector.shots = shots, theInspector.events = events;
        live.inspector = []() -> const Inspector & { return theInspector; };
        live.keyTables = [] { return KeyTable::newest; };
        find();
    }
    void find() { tracks.readFilm(live); }
    void write(const std::string &name, const std::string &text) const {
        common::writeWhole(folder / name, text);
    }
    std::string read(const std::string &name) const { return common::readWhole(folder / name); }
    bool has(const char *name, const char *what) const { return read(name).find(what) != std::string::npos; }
};

enum { kEyeX, kEyeY, kLens = 7, kTheLamp, kOtherX, kTheGrow = kOtherX + 8 };
using rocket::Interpolation::Ramp, rocket::Interpolation::Step;
constexpr auto kLinear = rocket::Interpolation::Linear, kSmooth = rocket::Interpolation::Smooth;
const CameraKey kView = {0, {8, 7, 6}, {5, 4, 3}, 0, 0};

TEST_F(Fixture, NamesThemAfterTheSource) {
    std::vector<std::string> names = tracks.names();
    ASSERT_EQ(names.size(), (size_t)kTheGrow + 1);
    const char *channels[] = {"eye.x", "eye.y", "eye.z", "target.x", "target.y", "target.z", "roll", "lens"};
    for (size_t c = 0; c < 8; ++c) EXPECT_EQ(names[c], std::string("start.camera.path:") + channels[c]);
    EXPECT_EQ(names[kTheLamp], "start:lamp");
    EXPECT_EQ(names[kOtherX], "end.camera.other:eye.x");
    EXPECT_EQ(names[kTheGrow], "end:grow");
}

TEST_F(Fixture, GivesTracksAsRocketDoes) {
    EXPECT_EQ(tracks.track(kLens), (rocket::Track{{16, {50, kSmooth}}})); // Rocket has no row -8
    EXPECT_EQ(tracks.track(kTheLamp),
              (rocket::Track{{0, {1, kLinear}}, {3, {2, kSmooth}}, {8, {3, kLinear}}}));
    EXPECT_EQ(tracks.track(kTheGrow), (rocket::Track{{104, {0, kLinear}}, {108, {1, kLinear}}}));
    EXPECT_EQ(tracks.offRows(), 8 + 1);
}

TEST_F(Fixture, TakesOverAnEditorsKeys) {
    tracks.takeFromEditor(kTheLamp, {{1, {5, Step}}, {3, {6, Ramp}}, {9, {7, kSmooth}}});
    tracks.takeFromEditor(kEyeY, {{4, {9, kLinear}}});
    tracks.show();
    EXPECT_EQ(keysOf(kLamp), (Keys{{1, 5, (float)kStep},
                                   {2.5f, 6, (float)kRamp}, // on the row of the film's own key
                                   {9, 7, (float)Smooth}}));
    // All numbers of the camera get a key on every row on which one of them has a key, as in the film's table
    EXPECT_EQ(keysOf(kPath),
              (Keys{{-8, 1, 2, 3, 4, 5, 6, 7, 40},                  // stays, because the editor cannot see it
                    {4, 1.5f, 9, 3.5f, 4.5f, 5.5f, 6.5f, 7.5f, 45}, // half-way between the film's keys
                    {16, 2, 9, 4, 5, 6, 7, 8, 50}}));               // eye.y keeps 9
    // The editor releases them
    tracks.takeFromEditor(kTheLamp, {});
    tracks.takeFromEditor(kEyeY, {});
    tracks.show();
    EXPECT_EQ(kLamp.keys[1].value, 2);
    EXPECT_EQ(kPath.count, 2);
}

TEST_F(Fixture, CountsRowsOfTheFilm) {
    tracks.takeFromEditor(kTheGrow, {{102, {1, kLinear}}});
    tracks.show();
    EXPECT_EQ(kGrow.keys[0].row, -2);
}

TEST_F(Fixture, HasKeysSetByHand) {
    EXPECT_EQ(tracks.setView(4, &kView), "");
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {8, kSmooth}}, {16, {2, kSmooth}}}));
    EXPECT_EQ(tracks.track(kLens)[4].value, 45); // the track's own value at that row
    EXPECT_EQ(tracks.setView(16, nullptr), "");
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {8, kSmooth}}}));
    EXPECT_EQ(tracks.setView(16, nullptr), "there is no key");
    // If the editor changes one of these keys, its value counts; the other keys stay
    tracks.takeFromEditor(kEyeX, {{16, {3, kSmooth}}});
    EXPECT_EQ(tracks.setView(4, &kView), "");
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {8, kSmooth}}, {16, {3, kSmooth}}}));
    tracks.takeFromEditor(kEyeX, {{4, {1, kSmooth}}, {16, {3, kSmooth}}});
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {1, kSmooth}}, {16, {3, kSmooth}}}));
    // The keys stay when the film is loaded again
    find();
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {1, kSmooth}}, {16, {3, kSmooth}}}));
    EXPECT_EQ(tracks.track(kEyeY), (rocket::Track{{4, {7, kSmooth}}}));
    EXPECT_EQ(kPath.poses[0].eye.y, 2);
}

TEST_F(Fixture, ARowNextToACutIsInTheVisibleShot) {
    theCut = 24 / kRowsPerSecond;
    find();
    EXPECT_EQ(tracks.rowOfView(23.4), 23u);
    EXPECT_EQ(tracks.rowOfView(23.6), 23u);
    EXPECT_EQ(tracks.rowOfView(24), 24u);
    EXPECT_EQ(tracks.rowOfView(24.6), 25u);
    EXPECT_EQ(tracks.rowOfView(0), 0u);
    theCut = 1e9;
    find();
    EXPECT_EQ(tracks.rowOfView(23.6), 24u);
}

TEST_F(Fixture, EditsAreWrittenToTheFiles) {
    EXPECT_EQ(tracks.save(message), "");
    EXPECT_EQ(message, "nothing to save");
    tracks.setView(4, &kView);
    tracks.takeFromEditor(kTheLamp, {{0, {1, kLinear}}, {3, {2.25f, kSmooth}}, {8, {3, kSmooth}}});
    tracks.show();
    EXPECT_EQ(tracks.unsaved(), 2);
    EXPECT_EQ(tracks.unsavedByHand(), 1);
    EXPECT_EQ(tracks.save(message), "");
    EXPECT_EQ(message, "saved film.keys, scenes/start.keys");
    EXPECT_TRUE(has("film.keys", "{4, {8, 7, 6}, {5, 4, 3}, 7.5, 45},\n")) << read("film.keys");
    EXPECT_TRUE(has("scenes/start.keys", "{2.5, 2.25, Smooth},\n    {8, 3, Smooth},\n"));
    EXPECT_EQ(tracks.unsaved(), 0);
    // Undo the edits: the files are as they were
    EXPECT_TRUE(tracks.undo());
    EXPECT_TRUE(tracks.undo());
    tracks.takeFromEditor(kTheLamp, {});
    EXPECT_EQ(tracks.save(message), "");
    EXPECT_EQ(read("film.keys"), kFilmKeys);
    EXPECT_EQ(read("scenes/start.keys"), kStartKeys);
}

TEST_F(Fixture, StepsAreNotSaved) {
    tracks.takeFromEditor(kTheLamp, {{0, {1, Step}}});
    std::string wrong = tracks.save(message);
    EXPECT_NE(wrong.find("start:lamp: the film has no steps and ramps"), std::string::npos) << wrong;
    EXPECT_EQ(read("scenes/start.keys"), kStartKeys);
}

TEST_F(Fixture, ATableThatNoFileHasIsNotEdited) {
    write("film.keys", "PATH(kNew, 24)\n    {0, {1, 2, 3}, {4, 5, 6}, 7, 40},\nEND\n");
    Tracks fresh{folder / ""};
    fresh.readFilm(live);
    EXPECT_EQ(fresh.names().size(), 2u);
    EXPECT_EQ(fresh.setView(4, &kView), "its path is not in a key file");
    write("film.keys", "int i;\n");
    fresh.readFilm(live);
    EXPECT_NE(fresh.setView(4, &kView).find("film.keys:1: expected TRACK"), std::string::npos);
}
