#include "maker/keys/key_tables.h"
#include "maker/panel/content.h"
#include "show/events.h"
#include "show/show.h"
#include "tests/support/thrown.h"
#include "tools/common/folders.h"
#include "tools/common/whole_file.h"
#define ODRAZ_LIVE
#include "timeline/keys.h"

#include <cstdlib>

using namespace odraz;
using namespace odraz::maker;
using common::readWhole;

constexpr char kFile[] = R"(// A scene.

TRACK(kDoor)
    {0, 0, Smooth}, // shut
    {rowOf(kLamp) + 8, 0.8, Linear}, // ajar
    {72, 1, Linear},
END

// Along the wall
PATH(kIn, 24) // as long as it takes
    {-64, {0.9, 0.86, 5.1}, {0, 0.6, 0}, 0, 37.8},
    // the second half
    {192, {0.05, 0.64, 3.3}, {0.22, 0.5, 0}, 0, 37.8},
END

PATH(kSink, 12)
    {144, {1, 2, 3}, {4, 5, 6}, 7, 40},
END
TRACK(kGrow, rowOf(kLamp))
    {3, 0, Smooth},
    {4, 1e-3, Linear},
END
)";
const Events kRows = {{"kLamp", 20}};

static size_t indexOf(const KeyFile &file, const std::string &name) {
    for (size_t i = 0; i < file.tables().size(); ++i)
        if (file.tables()[i].name == name) return i;
    ADD_FAILURE() << name;
    return 0;
}

using Change = std::function<void(std::vector<KeyNumbers> &)>;
static std::string with(const std::string &name, const Change &change) {
    KeyFile file("one.keys", kFile, kRows);
    size_t i = indexOf(file, name);
    std::vector<KeyNumbers> keys = file.tables()[i].keys;
    change(keys);
    file.set(i, keys);
    std::string text = file.text();
    EXPECT_EQ(KeyFile("one.keys", text, kRows).tables()[i].keys, keys) << text;
    return text;
}
static std::string replaced(const std::string &from, const std::string &to) {
    std::string text = kFile;
    size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}
static std::string problemOf(const std::string &text) {
    return thrown([&] { KeyFile("one.keys", text, kRows); });
}

// A folder of the show's layout, with one file.
struct KeyTablesTest : testing::Test {
    common::TemporaryFolder folder;
    std::string file = folder / "scenes/one.keys";
    KeyTables tables{folder / ""};

    KeyTablesTest() {
        std::filesystem::create_directory(folder / "scenes");
        rewrite(kFile);
    }
    // Writes the file as another program would, and reads it again.
    void rewrite(const std::string &text) {
        common::writeWhole(file, text);
        load();
    }
    void load() { tables.read({"scenes/one.keys"}, kRows); }
    int find(const std::string &name) const { return tables.find("scenes/one.keys", name); }
    const EditedTable &at(const std::string &name) const { return tables.tables()[(size_t)find(name)]; }
    void change(const std::string &name, const std::vector<KeyNumbers> &keys) {
        tables.change(find(name), keys);
    }
    std::string save() {
        std::set<std::string> written;
        return tables.save(written);
    }
    bool holds(const std::string &text) const { return readWhole(file).find(text) != std::string::npos; }
};

TEST(KeyFile, HasTablesByNameAndKind) {
    KeyFile file("one.keys", kFile, kRows);
    std::string all;
    for (const KeyFile::Table &t : file.tables())
        all += t.name + (t.camera ? " camera " : " ") + std::to_string(t.bits) + " bits, " +
               std::to_string(t.keys.size()) + "; ";
    EXPECT_EQ(all, "kDoor 24 bits, 3; kIn camera 24 bits, 2; kSink camera 12 bits, 1; kGrow 24 bits, 2; ");
    EXPECT_EQ(file.tables()[0].keys[1], (KeyNumbers{28, 0.8f, 0}));
    EXPECT_EQ(file.tables()[1].keys[0], (KeyNumbers{-64, 0.9f, 0.86f, 5.1f, 0, 0.6f, 0, 0, 37.8f}));
    EXPECT_EQ(file.tables()[3].keys[1], (KeyNumbers{4, 0.001f, 0}));
    EXPECT_EQ(file.text(), kFile);
}

TEST(KeyFile, OnlyTheKeyThatChangedIsWritten) {
    EXPECT_EQ(with("kIn", [](auto &k) { k[1][2] = 0.7f; }), replaced("0.64", "0.7"));
    EXPECT_EQ(with("kIn", [](auto &k) { k[0][8] = 40; }), replaced("37.8", "40"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k[2][2] = 1; }), replaced("72, 1, Linear", "72, 1, Smooth"));
    EXPECT_EQ(with("kGrow", [](auto &k) { k[0][1] = -0.5f; }), replaced("{3, 0,", "{3, -0.5,"));
    EXPECT_EQ(with("kIn", [](auto &) {}), kFile);
}

TEST(KeyFile, NamedRowsStayNamed) {
    EXPECT_EQ(with("kDoor", [](auto &k) { k[1][0] += 4; }), replaced("(kLamp) + 8", "(kLamp) + 12"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k[1][0] -= 8; }), replaced("(kLamp) + 8", "(kLamp)"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k[1][0] -= 10; }), replaced("(kLamp) + 8", "(kLamp) - 2"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k[1][1] = 0.5f; }), replaced("0.8", "0.5"));
}

TEST(KeyFile, CommentsStayWhenKeysAreAddedOrRemoved) {
    auto inserted = [](const std::string &name, int at, const KeyNumbers &key) {
        return with(name, [&](auto &k) { k.insert(k.begin() + at, key); });
    };
    EXPECT_EQ(inserted("kDoor", 1, {8, 0.25f, 1}),
              replaced("// shut\n", "// shut\n    {8, 0.25, Smooth},\n"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k.erase(k.begin() + 1); }),
              replaced("    {rowOf(kLamp) + 8, 0.8, Linear}, // ajar", "    // ajar"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k.erase(k.begin()); }),
              replaced("    {0, 0, Smooth}, // shut", "    // shut"));
    EXPECT_EQ(with("kIn", [](auto &k) { k.pop_back(); }),
              replaced("    {192, {0.05, 0.64, 3.3}, {0.22, 0.5, 0}, 0, 37.8},\n", ""));
    EXPECT_EQ(inserted("kSink", 1, {200, 1, 2, 3, 4, 5, 6, 7, 50}),
              replaced("7, 40},\n", "7, 40},\n    {200, {1, 2, 3}, {4, 5, 6}, 7, 50},\n"));
    EXPECT_EQ(inserted("kIn", 0, {-99, 1, 2, 3, 4, 5, 6, 7, 50}),
              replaced("    {-64", "    {-99, {1, 2, 3}, {4, 5, 6}, 7, 50},\n    {-64"));
}

TEST(KeyFile, AnyEditIsReadBack) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1e4f, 1e4f);
    for (int round = 0; round < 500; ++round)
        with(round % 2 ? "kIn" : "kDoor", [&](std::vector<KeyNumbers> &keys) {
            for (int n = (int)(random() % 4); n >= 0; --n) {
                size_t i = random() % keys.size(), k = random() % keys[0].size();
                float x = number(random) * std::pow(10.f, -(float)(random() % 8));
                if (keys[0].size() == 3 && k == 2) x = (float)(random() % 2);
                if (k == 0) x = (float)(int)x;
                unsigned way = random() % 3; // insert, change or erase
                if (way == 0) keys.insert(keys.begin() + (long)i, keys[i]);
                if (way < 2)
                    keys[i][k] = x;
                else if (keys.size() > 1)
                    keys.erase(keys.begin() + (long)i);
            }
            std::stable_sort(keys.begin(), keys.end(), [](auto &a, auto &b) { return a[0] < b[0]; });
        });
}

TEST(KeyFile, NumbersAreShortAndExact) {
    EXPECT_EQ(written(2), "2");
    EXPECT_EQ(written(-0.5f), "-0.5");
    EXPECT_EQ(written(37.8f), "37.8");
    EXPECT_EQ(written(1200), "1200");
    EXPECT_EQ(written(-0.f), "0");
    std::mt19937 random(1);
    for (int i = 0; i < 10000; ++i) {
        float x = std::ldexp((float)random(), -(int)(random() % 45));
        EXPECT_EQ((float)std::strtod(written(x).c_str(), nullptr), x) << written(x);
    }
}

TEST(KeyFile, ErrorsAreReportedWithTheirLine) {
    const std::pair<const char *, const char *> kWrong[] = {
        {"static int i;\n", "one.keys:1: expected TRACK(name) or PATH(name, bits)"},
        {"{0, 0, Linear},\n", "one.keys:1: expected TRACK"},
        {"TRACK(kA)\n", "one.keys: END is missing"},
        {"TRACK(kA)\nEND\n", "one.keys:2: the table has no keys"},
        {"TRACK(kA\n", "one.keys:1: expected ')'"},
        {"PATH(kA)\n", "one.keys:1: expected ','"},
        {"TRACK(kA)\nTRACK(kB)\n", "one.keys:2: expected '{'"},
        {"\nTRACK(kA)\n{0, 0.5f, Linear},\nEND\n", "one.keys:3: expected ','"},
        {"TRACK(kA)\n{0, 1, Cubic},\nEND\n", "one.keys:2: expected Linear or Smooth, not 'Cubic'"},
        {"TRACK(kA)\n{0, 1, Linear}\nEND\n", "one.keys:2: expected ','"},
        {"TRACK(kA)\n{0, nan, Linear},\nEND\n", "one.keys:2: expected a number"},
        {"TRACK(kA)\n{0, 1e99, Linear},\nEND\n", "one.keys:2: expected a number"},
        {"TRACK(kA)\n{0, 1, Linear}, {1, 1, Linear},\nEND\n", "one.keys:2: unexpected '{1"},
        {"TRACK(kA)\n{rowOf(kNone), 1, Linear},\nEND\n", "one.keys:2: there is no event 'kNone'"},
        {"TRACK(kA)\n{1, 1, Linear},\n{0, 1, Linear},\nEND\n", "one.keys:3: rows must ascend"},
        {"PATH(kA, 8)\n{0, {1, 2, 3}, {1, 2}, 0, 40},\nEND\n", "one.keys:2: expected ','"},
    };
    for (auto [text, problem] : kWrong) EXPECT_EQ(problemOf(text).rfind(problem, 0), 0u) << problemOf(text);
    EXPECT_EQ(problemOf(""), "");
    EXPECT_EQ(problemOf("// TRACK(kA)\n"), "");
    std::mt19937 random(3);
    for (int i = 0; i < 3000; ++i) {
        std::string text = kFile;
        for (int n = 0; n < 3; ++n) text[random() % text.size()] = "{}(),;/*"[random() % 8];
        text.resize(random() % text.size());
        problemOf(text);
    }
}

// --- The film's key files ---

// Includes them as scenes do, so that KeyTable's list has all tables
namespace {
namespace film {
#include "show/film.keys"
}
namespace point {
#include "show/scenes/point.keys"
}
namespace flake {
#include "show/scenes/flake.keys"
}
namespace patches {
#include "show/scenes/patches.keys"
}
namespace hall {
#include "show/scenes/hall.keys"
}
namespace end {
#include "show/scenes/odraz.keys"
}
namespace credits {
#include "show/scenes/credits.keys"
}
} // namespace

TEST(KeysOfTheFilm, AreTheSameForMakerAndProgram) {
    Events rows;
    for (const EventInfo &e : contentOf(inspector()).events) rows[e.name] = e.row;
    std::set<std::vector<KeyNumbers>> paths;
    int count = 0;
    for (const KeyTable *t = KeyTable::newest; t; t = t->next, ++count) {
        std::filesystem::path path = t->file;
        KeyFile file(path.filename(), readWhole(ODRAZ_SOURCE / path), rows);
        std::vector<KeyNumbers> keys;
        for (int i = 0; i < t->count; ++i)
            keys.push_back(t->camera ? numbersOf(t->poses[i]) : numbersOf(t->keys[i]));
        EXPECT_EQ(file.tables()[indexOf(file, t->name)].keys, keys) << t->file << " " << t->name;
        if (t->camera) paths.insert(keys);
        // A track's scene is found by its file name
        EXPECT_TRUE(t->camera || std::any_of(kScenes, kScenes + kSceneCount,
                                             [&](const SceneEntry &s) { return s.name == path.stem(); }))
            << path;
    }
    EXPECT_GE(count, 45);
    for (int i = 0; i < kFilm.count; ++i) {
        CameraPath path = kFilm.shots[i].path;
        std::vector<KeyNumbers> keys;
        for (int k = 0; k < path.count; ++k) keys.push_back(numbersOf(path.keys[k]));
        EXPECT_TRUE(paths.count(keys)) << "shot " << i;
    }
}

// --- Edits ---

TEST_F(KeyTablesTest, StepsAreUndoneAndRedone) {
    EXPECT_EQ(find("kNone"), -1);
    EXPECT_FALSE(tables.undo());
    change("kDoor", {{9, 1, 0}, {3, 0, 1}});
    EXPECT_EQ(at("kDoor").keys, (std::vector<KeyNumbers>{{3, 0, 1}, {9, 1, 0}}));
    change("kDoor", {{5, 1, 0}});
    EXPECT_EQ(tables.edited(), 1);
    EXPECT_TRUE(tables.undo());
    EXPECT_TRUE(tables.undo());
    EXPECT_FALSE(tables.undo());
    EXPECT_EQ(tables.edited(), 0);
    EXPECT_TRUE(tables.redo());
    change("kDoor", {{7, 1, 0}});
    EXPECT_FALSE(tables.redo()) << "the step that was undone is gone";
}

TEST_F(KeyTablesTest, KeysAreRoundedAsTheTableIs) {
    change("kSink", {{144, 1.00001f, 2, 3, 4, 5, 6, 7.00001f, 40}});
    EXPECT_EQ(at("kSink").keys[0], (KeyNumbers{144, 1, 2, 3, 4, 5, 6, 7.00001f, 40}));
}

TEST_F(KeyTablesTest, AreSavedAndSavedBack) {
    std::vector<KeyNumbers> keys = at("kDoor").keys;
    keys[2][1] = 0.95f;
    change("kDoor", keys);
    change("kGrow", {{3, 0.5f, 1}, {4, 1, 0}});
    EXPECT_EQ(save(), "");
    EXPECT_TRUE(holds("{72, 0.95, Linear},\n")) << readWhole(file);
    EXPECT_TRUE(holds("    {3, 0.5, Smooth},\n    {4, 1, Linear},\n")) << readWhole(file);
    EXPECT_EQ(tables.edited(), 0);
    load(); // as after the film was rebuilt: the steps can still be undone
    tables.undo();
    tables.undo();
    EXPECT_EQ(tables.edited(), 2);
    EXPECT_EQ(save(), "");
    EXPECT_EQ(readWhole(file), replaced("1e-3", "0.001"));
}

TEST_F(KeyTablesTest, AreNotSavedOverAnothersEdits) {
    change("kDoor", {{5, 1, 0}});
    std::string theirs = kFile + std::string("// mine\n");
    common::writeWhole(file, theirs);
    EXPECT_NE(save().find("one.keys was changed by another program"), std::string::npos);
    EXPECT_EQ(readWhole(file), theirs);
    EXPECT_EQ(tables.edited(), 1);
    // After it was read again, the edit is saved on top of it
    load();
    EXPECT_EQ(tables.edited(), 1);
    EXPECT_EQ(save(), "");
    EXPECT_TRUE(holds("    {5, 1, Linear}, // shut\n    // ajar\nEND"));
    EXPECT_TRUE(holds("// mine"));
    std::filesystem::remove(file);
    change("kDoor", {{6, 1, 0}});
    EXPECT_NE(save(), "");
    EXPECT_FALSE(std::filesystem::exists(file));
    load();
    EXPECT_NE(tables.problems().find("one.keys"), std::string::npos);
    EXPECT_EQ(at("kDoor").keys[0][0], 6) << "an edit is not lost with its file";
}

TEST_F(KeyTablesTest, AnothersEditOfTheSameTableIsKept) {
    change("kDoor", {{5, 1, 0}});
    change("kGrow", {{5, 1, 0}});
    std::string theirs = replaced("{72, 1, Linear}", "{72, 2, Linear}");
    rewrite(theirs);
    EXPECT_EQ(at("kDoor").keys[0][0], 5) << "it is still shown";
    EXPECT_NE(save().find("one.keys was changed by another program, which also edited kDoor"),
              std::string::npos);
    EXPECT_EQ(readWhole(file), theirs);
    // After an undo, the other program's edit is read
    EXPECT_TRUE(tables.undo());
    EXPECT_TRUE(tables.undo());
    load();
    EXPECT_EQ(at("kDoor").keys[2][1], 2);
    EXPECT_EQ(tables.edited(), 0);
    EXPECT_TRUE(tables.redo()) << "of kGrow alone";
    EXPECT_FALSE(tables.redo());
    EXPECT_EQ(save(), "");
}

TEST_F(KeyTablesTest, AFileReplacesUneditedTables) {
    rewrite(replaced("{72, 1, Linear}", "{72, 2, Linear}"));
    EXPECT_EQ(at("kDoor").keys[2][1], 2);
    EXPECT_EQ(tables.edited(), 0);
    rewrite("TRACK(kDoor)\n");
    EXPECT_NE(tables.problems().find("END is missing"), std::string::npos);
    EXPECT_EQ(at("kDoor").keys[2][1], 2);
    change("kDoor", {{5, 1, 0}});
    rewrite("TRACK(kOther)\n    {0, 1, Linear},\nEND\n");
    EXPECT_NE(save().find("also edited kDoor"), std::string::npos) << "it is gone from the file";
}
