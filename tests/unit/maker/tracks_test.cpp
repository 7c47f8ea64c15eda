#include "maker/tracks.h"

#include "maker/rocket/document.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace odraz;

namespace {

// A film of two scenes: a camera's path and a track in the first, in the second one table that is read twice.
constexpr CameraKey kPath[] = {{-8, {1, 2, 3}, {4, 5, 6}, 7, 40}, {16, {2, 3, 4}, {5, 6, 7}, 8, 50}};
constexpr Key kLamp[] = {
    {0, 1, Interpolation::Linear}, {2.5f, 2, Interpolation::Smooth}, {8, 3, Interpolation::Linear}};
constexpr Key kGrow[2][2] = {{{0, 0, Interpolation::Linear}, {4, 1, Interpolation::Linear}},
                             {{4, 0, Interpolation::Linear}, {8, 1, Interpolation::Linear}}};

const Table kTables[] = {{kPath, 2, 0, true, 0},
                         {kLamp, 3, 0, false, 0},
                         {kGrow[0], 2, 1, false, 100},
                         {kGrow[1], 2, 1, false, 100}};
const Replaced *theReplaced;
int theCount;

int findTables(Intro &, Table *to, int) {
    for (const Table &t : kTables) *to++ = t;
    return 4;
}
const char *sceneName(int scene) { return scene ? "end" : "start"; }
double theCut = 1e9; // where another shot begins, in seconds
const CameraKey *pathAt(double seconds) { return seconds < theCut ? kPath : kPath + 1; }
void replaceTables(const Replaced *all, int count) {
    theReplaced = all;
    theCount = count;
}

// What the film's source says.
constexpr char kSource[] = R"(constexpr CameraKey kPath[] = {
    {-8, {1, 2, 3}, {4, 5, 6}, 7, 40},
    {16, {2, 3, 4}, {5, 6, 7}, 8, 50},
};
constexpr Key kLamp[] = {
    {0, 1, Interpolation::Linear}, {2.5f, 2, Interpolation::Smooth}, {8, 3, Interpolation::Linear}};
)";
struct Show {
    std::string folder = testing::TempDir() + "tracks_test." + std::to_string(getpid());
    Show() {
        std::filesystem::create_directories(folder);
        write(kSource);
        std::ofstream(folder + "/.clang-format") << "ColumnLimit: 110\nIndentWidth: 4\n";
    }
    ~Show() { std::filesystem::remove_all(folder); }
    void write(const std::string &text) const { std::ofstream(folder + "/film.cpp") << text; }
    std::string text() const {
        std::ifstream in(folder + "/film.cpp");
        return {std::istreambuf_iterator<char>(in), {}};
    }
    bool has(const char *what) const { return text().find(what) != std::string::npos; }
};

struct Fixture : testing::Test {
    Fixture() {
        live.findTables = findTables;
        live.sceneName = sceneName;
        live.pathAt = pathAt;
        live.replaceTables = replaceTables;
        find();
    }
    void find() {
        tracks.find(live, *(Intro *)&live, // which none of these functions reads
                    {{(const char *)kPath, sizeof kPath, "kPath"},
                     {(const char *)kLamp, sizeof kLamp, "kLamp"},
                     {(const char *)kGrow, sizeof kGrow, "kGrow"}});
    }
    Show show;
    Live live = {};
    Tracks tracks{show.folder};
    std::string news;
};

// What the film reads instead of a table.
const Replaced *instead(const void *keys) {
    for (int i = 0; i < theCount; ++i)
        if (theReplaced[i].keys == keys) return theReplaced + i;
    return nullptr;
}
enum { kEyeX, kEyeY, kLens = 7, kTheLamp, kGrow0, kGrow1 };
using rocket::Interpolation::Ramp, rocket::Interpolation::Step;
constexpr auto kLinear = rocket::Interpolation::Linear, kSmooth = rocket::Interpolation::Smooth;

} // namespace

TEST_F(Fixture, NamesThemAfterTheSource) {
    EXPECT_EQ(tracks.names(),
              (std::vector<std::string>{"start.camera.path:eye.x", "start.camera.path:eye.y",
                                        "start.camera.path:eye.z", "start.camera.path:target.x",
                                        "start.camera.path:target.y", "start.camera.path:target.z",
                                        "start.camera.path:roll", "start.camera.path:lens", "start:lamp",
                                        "end:grow0", "end:grow1"}));
}

TEST_F(Fixture, NamesThemWithoutSymbolsToo) {
    tracks.find(live, *(Intro *)&live, {});
    EXPECT_EQ(tracks.names()[0], "start.camera.track:eye.x");
    EXPECT_EQ(tracks.names()[kGrow0], "end:track");
    EXPECT_EQ(tracks.names()[kGrow1], "end:track-2");
}

TEST_F(Fixture, SaysThemAsRocketDoes) {
    EXPECT_EQ(tracks.track(kLens), (rocket::Track{{16, {50, kSmooth}}})); // row -8 is none
    EXPECT_EQ(tracks.track(kTheLamp),
              (rocket::Track{{0, {1, kLinear}}, {3, {2, kSmooth}}, {8, {3, kLinear}}}));
    EXPECT_EQ(tracks.track(kGrow1), (rocket::Track{{104, {0, kLinear}}, {108, {1, kLinear}}}));
    EXPECT_EQ(tracks.offRows(), 8 + 1);
    EXPECT_EQ(theCount, 0); // nothing was edited
}

TEST_F(Fixture, TakesWhatAnEditorHas) {
    tracks.takeFromEditor(kTheLamp, {{1, {5, Step}}, {3, {6, Ramp}}, {9, {7, kSmooth}}});
    tracks.takeFromEditor(kEyeY, {{4, {9, kLinear}}});
    tracks.show();
    ASSERT_EQ(theCount, 2);
    const Track &lamp = instead(kLamp)->track;
    ASSERT_EQ(lamp.count, 3);
    EXPECT_EQ(lamp.keys[0].interpolation, kStep);
    EXPECT_EQ(lamp.keys[1].row, 2.5f); // where the film's own key is
    EXPECT_EQ(lamp.keys[1].interpolation, kRamp);
    EXPECT_EQ(lamp.keys[2].row, 9);
    EXPECT_EQ(lamp.keys[2].value, 7);
    const CameraPath *channels = instead(kPath)->channels;
    // All numbers of the camera have a key on every row that one of them has, as the film's table will
    ASSERT_EQ(channels[kEyeY].count, 3);
    const CameraKey *path = channels[kEyeY].keys;
    EXPECT_EQ(path[0].row, -8); // which the editor cannot see: it stays
    EXPECT_EQ(path[0].eye.y, 2);
    EXPECT_EQ(path[1].row, 4);
    EXPECT_EQ(path[1].eye.y, 9);
    EXPECT_EQ(path[1].eye.x, 1.5f); // half-way
    EXPECT_EQ(path[2].row, 16);
    EXPECT_EQ(path[2].eye.y, 9); // holds
    EXPECT_EQ(path[2].eye.x, 2);
    // It lets go of them
    tracks.takeFromEditor(kTheLamp, {});
    tracks.takeFromEditor(kEyeY, {});
    tracks.show();
    EXPECT_EQ(theCount, 0);
}

TEST_F(Fixture, CountsRowsOfTheFilm) {
    tracks.takeFromEditor(kGrow1, {{102, {1, kLinear}}});
    tracks.show();
    ASSERT_TRUE(instead(kGrow[1]));
    EXPECT_FALSE(instead(kGrow[0]));
    EXPECT_EQ(instead(kGrow[1])->track.keys[0].row, 2);
}

TEST_F(Fixture, HasKeysSetByHand) {
    CameraKey view = {0, {8, 7, 6}, {5, 4, 3}, 0, 0};
    EXPECT_EQ(tracks.setView(4, view), "");
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {8, kSmooth}}, {16, {2, kSmooth}}}));
    EXPECT_EQ(tracks.track(kLens)[4].value, 45); // as it is there
    EXPECT_EQ(tracks.removeView(16), "");
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {8, kSmooth}}}));
    EXPECT_EQ(tracks.removeView(16), "there is no key");
    // An editor that changes a key of these has the last word; others stay
    tracks.takeFromEditor(kEyeX, {{16, {3, kSmooth}}});
    EXPECT_EQ(tracks.setView(4, view), "");
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {8, kSmooth}}, {16, {3, kSmooth}}}));
    tracks.takeFromEditor(kEyeX, {{4, {1, kSmooth}}, {16, {3, kSmooth}}});
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {1, kSmooth}}, {16, {3, kSmooth}}}));
    // A film that is loaded anew keeps all that
    find();
    EXPECT_EQ(tracks.track(kEyeX), (rocket::Track{{4, {1, kSmooth}}, {16, {3, kSmooth}}}));
    EXPECT_EQ(tracks.track(kEyeY), (rocket::Track{{4, {7, kSmooth}}}));
    EXPECT_EQ(theCount, 1);
}

TEST_F(Fixture, StepsAreUndone) {
    EXPECT_FALSE(tracks.undo());
    tracks.setView(4, {0, {8, 7, 6}, {5, 4, 3}, 0, 0});
    tracks.setView(4, {0, {9, 7, 6}, {5, 4, 3}, 0, 0});
    EXPECT_TRUE(tracks.undo());
    EXPECT_EQ(tracks.track(kEyeX)[4].value, 8);
    EXPECT_TRUE(tracks.undo());
    EXPECT_FALSE(tracks.undo());
    EXPECT_EQ(tracks.unsaved(), 0);
    tracks.show();
    EXPECT_EQ(theCount, 0);
    EXPECT_TRUE(tracks.redo());
    EXPECT_EQ(tracks.unsaved(), 1);
}

TEST_F(Fixture, WhatAnEditorHasIsNotSaved) {
    tracks.takeFromEditor(kTheLamp, {{0, {1, kLinear}}, {3, {2.25f, kSmooth}}, {8, {3, kSmooth}}});
    tracks.show();
    EXPECT_EQ(tracks.unsaved(), 1);
    EXPECT_EQ(tracks.unsavedByHand(), 0);
    EXPECT_EQ(tracks.save(news), "");
    EXPECT_EQ(tracks.unsaved(), 0);
    tracks.takeFromEditor(kTheLamp, {});
    tracks.show();
    EXPECT_EQ(tracks.unsaved(), 0);
}

TEST_F(Fixture, ARowBesideACutIsInTheShotThatIsSeen) {
    theCut = 24 / kRowsPerSecond;
    EXPECT_EQ(tracks.rowOfView(23.4), 23u);
    EXPECT_EQ(tracks.rowOfView(23.6), 23u);
    EXPECT_EQ(tracks.rowOfView(24), 24u);
    EXPECT_EQ(tracks.rowOfView(24.6), 25u);
    EXPECT_EQ(tracks.rowOfView(0), 0u);
    theCut = 1e9;
    EXPECT_EQ(tracks.rowOfView(23.6), 24u);
}

TEST_F(Fixture, OfTwoTablesOfOneNameNoneIsEdited) {
    show.write(std::string(kSource) +
               "void f() {\n    constexpr Key kLamp[] = {{0, 1, Linear}, {1, 1, Linear}, "
               "{2, 1, Linear}};\n}\n");
    find();
    tracks.takeFromEditor(kTheLamp, {{0, {1, kLinear}}, {3, {2.25f, kSmooth}}});
    std::string wrong = tracks.save(news);
    EXPECT_NE(wrong.find("start:lamp: "), std::string::npos) << wrong;
    EXPECT_NE(wrong.find("stands twice"), std::string::npos) << wrong;
    EXPECT_EQ(show.text().find("2.25f"), std::string::npos);
}

TEST_F(Fixture, WhatWasEditedBecomesSource) {
    EXPECT_EQ(tracks.save(news), "");
    EXPECT_EQ(news, "nothing to save");
    tracks.setView(4, {0, {8, 7, 6}, {5, 4, 3}, 0, 0});
    tracks.takeFromEditor(kTheLamp, {{0, {1, kLinear}}, {3, {2.25f, kSmooth}}, {8, {3, kSmooth}}});
    EXPECT_EQ(tracks.save(news), "");
    EXPECT_EQ(news, "saved film.cpp");
    EXPECT_TRUE(show.has("{4, {8, 7, 6}, {5, 4, 3}, 7.5f, 45}")) << show.text();
    EXPECT_TRUE(show.has("{2.5f, 2.25f, Interpolation::Smooth}, {8, 3, Interpolation::Smooth}};"))
        << show.text();
    EXPECT_EQ(tracks.unsaved(), 0);
    // The step is undone, and the source is as it was
    EXPECT_TRUE(tracks.undo());
    EXPECT_TRUE(tracks.undo());
    tracks.takeFromEditor(kTheLamp, {});
    EXPECT_EQ(tracks.save(news), "");
    EXPECT_EQ(show.text(), kSource);
}

TEST_F(Fixture, WhatTheFilmHasNotIsNotSaved) {
    tracks.takeFromEditor(kTheLamp, {{0, {1, Step}}});
    tracks.takeFromEditor(kGrow0, {{101, {1, kLinear}}});
    std::string wrong = tracks.save(news);
    EXPECT_NE(wrong.find("start:lamp: the film has no steps and ramps"), std::string::npos) << wrong;
    EXPECT_NE(wrong.find("end:grow0: its numbers are computed, in a header"), std::string::npos) << wrong;
    EXPECT_EQ(show.text(), kSource);
    // A file that somebody else wrote meanwhile stays theirs, and the edit stays to be seen
    show.write(std::string(kSource) + "// mine\n");
    tracks.setView(4, {0, {8, 7, 6}, {5, 4, 3}, 0, 0});
    EXPECT_NE(tracks.save(news).find("film.cpp was changed meanwhile"), std::string::npos);
    EXPECT_TRUE(show.has("// mine"));
    // Once what the other wrote is built and loaded, the edit goes on top of it
    find();
    EXPECT_EQ(tracks.track(kEyeX)[4].value, 8);
    EXPECT_EQ(tracks.save(news).find("film.cpp"), std::string::npos);
    EXPECT_TRUE(show.has("// mine"));
    EXPECT_TRUE(show.has("{4, {8, 7, 6}"));
}

TEST_F(Fixture, WhoWroteTheSameTableKeepsIt) {
    tracks.setView(4, {0, {8, 7, 6}, {5, 4, 3}, 0, 0});
    show.write("constexpr CameraKey kOther[] = {{0, {1, 2, 3}, {4, 5, 6}, 7, 40}};\n");
    find();
    EXPECT_EQ(tracks.track(kEyeX)[4].value, 8);
    EXPECT_NE(tracks.save(news).find("film.cpp was changed meanwhile"), std::string::npos);
    EXPECT_TRUE(show.has("kOther"));
    // Once it is undone, what the other wrote is taken
    EXPECT_TRUE(tracks.undo());
    find();
    EXPECT_NE(tracks.setView(4, {0, {8, 7, 6}, {5, 4, 3}, 0, 0}), "");
}

TEST_F(Fixture, WhatAnEditorOpenedIsTheSame) {
    for (size_t i = 0; i < tracks.names().size(); ++i) tracks.takeFromEditor(i, tracks.track(i));
    tracks.show();
    ASSERT_EQ(theCount, 4);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(instead(kLamp)->track.keys[i].row, kLamp[i].row);
        EXPECT_EQ(instead(kLamp)->track.keys[i].value, kLamp[i].value);
        EXPECT_EQ(instead(kLamp)->track.keys[i].interpolation, kLamp[i].interpolation);
    }
    const CameraPath &lens = instead(kPath)->channels[kLens];
    ASSERT_EQ(lens.count, 2);
    EXPECT_EQ(lens.keys[0].row, -8);
    EXPECT_EQ(lens.keys[0].fov, 40);
    EXPECT_EQ(lens.keys[1].fov, 50);
}

TEST_F(Fixture, WritesADocument) {
    EXPECT_EQ(rocket::document({"a:b"}, {{{3, {0.1f, Ramp}}, {4, {-2, Step}}}}, 17),
              "<sync rows=\"17\">\n\t<tracks startRow=\"0\" endRow=\"16\">\n\t\t<track name=\"a:b\">\n"
              "\t\t\t<key row=\"3\" value=\"0.100000001\" interpolation=\"3\"/>\n"
              "\t\t\t<key row=\"4\" value=\"-2\" interpolation=\"0\"/>\n"
              "\t\t</track>\n\t</tracks>\n\t<bookmarks/>\n</sync>\n");
}
