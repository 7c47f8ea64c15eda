#include "maker/source/edits.h"
#include "show/show.h"
#include "timeline/shot.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <set>

using namespace odraz;
using namespace odraz::maker;

namespace {

constexpr char kFile[] = R"(// A scene.
using enum Interpolation;
static constexpr Key kDoor[] = {
    {0, 0, Smooth},                   // shut
    {rowOf(kLamp) + 8, 0.8f, Linear}, // ajar
    {72, 1, Linear},
};
static constexpr CameraKey kIn[] = {
    {-64, {0.9f, 0.86f, 5.1f}, {0.0f, 0.60f, 0}, 0, 37.8f},
    {192, {0.05f, 0.64f, 3.3f}, {0.22f, 0.50f, 0}, 0, 37.8f},
};
static constexpr auto kSink = coarse<12>({
    around(128, 5.9f, 5.0f, 2.6f, 0.48f, 38.7f),
    {144, {1, 2, 3}, {4, 5, 6}, 7, 40},
});
constexpr Key kGrow[kLevels][2] = {{{1, 0, Smooth}, {2, 1, Linear}}, {{3, 0, Smooth}, {4, 1, Linear}}};
static constexpr Keys<2> kMade = made(0);
)";

// The keys of a table whose numbers all are numbers; rows that are named count from 20.
std::vector<KeyNumbers> keysOf(const std::string &text, const SourceTable &table) {
    std::vector<KeyNumbers> keys;
    for (const SourceKey &key : table.keys) {
        KeyNumbers numbers;
        for (const Span &s : key.numbers) {
            std::string word = text.substr(s.begin, s.end - s.begin);
            if (word == "Linear" || word == "Smooth")
                numbers.push_back(word == "Smooth");
            else if (word.rfind("rowOf", 0) == 0) {
                size_t sign = word.find_last_of("+-");
                float offset = sign == std::string::npos ? 0 : std::strtof(word.c_str() + sign + 1, nullptr);
                numbers.push_back(20 + (sign != std::string::npos && word[sign] == '-' ? -offset : offset));
            } else
                numbers.push_back(std::strtof(word.c_str(), nullptr));
        }
        keys.push_back(rounded(table, numbers));
    }
    return keys;
}

SourceTable tableOf(const std::string &text, const std::string &name) {
    for (const SourceTable &t : findTables(text))
        if (t.name == name) return t;
    ADD_FAILURE() << name;
    return {};
}

std::string with(const std::string &name, const std::function<void(std::vector<KeyNumbers> &)> &change) {
    SourceTable table = tableOf(kFile, name);
    std::vector<KeyNumbers> before = keysOf(kFile, table), after = before;
    change(after);
    std::string text = withKeys(kFile, table, before, after);
    EXPECT_EQ(keysOf(text, tableOf(text, name)), after) << text;
    return text;
}
std::string replaced(const std::string &from, const std::string &to) {
    std::string text = kFile;
    size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

// A folder like the show's, with one file.
struct Folder {
    std::string path = testing::TempDir() + "source_test." + std::to_string(getpid());
    std::string file = path + "/scenes/one.cpp";
    Folder() {
        std::filesystem::create_directories(path + "/scenes");
        std::ofstream(path + "/.clang-format") << "BasedOnStyle: LLVM\nColumnLimit: 110\nIndentWidth: 4\n";
        std::ofstream(path + "/none.cpp") << "int none;\n";
        std::ofstream(file) << kFile;
    }
    ~Folder() { std::filesystem::remove_all(path); }
    std::string text() const {
        std::ifstream in(file);
        return {std::istreambuf_iterator<char>(in), {}};
    }
};
void setBuilt(Edits &edits) {
    for (size_t i = 0; i < edits.tables().size(); ++i) {
        const SourceTable &t = edits.tables()[i].source;
        if (t.name != "kSink") edits.setBuilt((int)i, keysOf(kFile, t));
    }
}

} // namespace

TEST(SourceTables, AreFoundByNameKindAndSize) {
    std::vector<SourceTable> tables = findTables(kFile);
    ASSERT_EQ(tables.size(), 5u);
    const char *names[] = {"kDoor", "kIn", "kSink", "kGrow[0]", "kGrow[1]"};
    size_t counts[] = {3, 2, 2, 2, 2};
    for (size_t i = 0; i < tables.size(); ++i) {
        EXPECT_EQ(tables[i].name, names[i]);
        EXPECT_EQ(tables[i].keys.size(), counts[i]);
        EXPECT_EQ(tables[i].kind, i == 1 || i == 2 ? TableKind::Path : TableKind::Track);
        EXPECT_EQ(tables[i].bits, i == 2 ? 12 : 0);
    }
    EXPECT_TRUE(tables[2].keys[0].numbers.empty());
    EXPECT_EQ(tables[2].keys[1].numbers.size(), 9u);
}

TEST(SourceTables, WhatIsNoCodeIsNoTable) {
    const std::string table = "constexpr Key kOne[] = {{0, 1, Linear}};\n";
    for (const std::string &text :
         {"// " + table, "/* " + table + "*/\n", "#if 0\n" + table + "#endif\n", "/* " + table,
          "#if 0\n" + table, "const char *a = \"" + table.substr(0, table.size() - 1) + "\";\n"}) {
        EXPECT_TRUE(findTables(text).empty()) << text;
        std::vector<SourceTable> found = findTables("const char *s = \"// \\\" /* \";\n" + table + text);
        ASSERT_EQ(found.size(), 1u) << text;
        EXPECT_EQ(found[0].keys[0].whole.begin, 53u) << text;
    }
}

TEST(SourceTables, OnlyTheNumberThatChangedIsWritten) {
    EXPECT_EQ(with("kIn", [](auto &k) { k[1][2] = 0.7f; }), replaced("0.64f", "0.7f"));
    EXPECT_EQ(with("kIn", [](auto &k) { k[0][8] = 40; }), replaced("37.8f", "40"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k[2][2] = 1; }), replaced("72, 1, Linear", "72, 1, Smooth"));
    EXPECT_EQ(with("kGrow[1]", [](auto &k) { k[0][1] = -0.5f; }), replaced("{3, 0,", "{3, -0.5f,"));
    EXPECT_EQ(with("kIn", [](auto &) {}), kFile);
}

TEST(SourceTables, NamedRowsStayNamed) {
    EXPECT_EQ(with("kDoor", [](auto &k) { k[1][0] += 4; }), replaced("(kLamp) + 8", "(kLamp) + 12"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k[1][0] -= 8; }), replaced("(kLamp) + 8", "(kLamp)"));
    EXPECT_EQ(with("kDoor", [](auto &k) { k[1][0] -= 10; }), replaced("(kLamp) + 8", "(kLamp) - 2"));
}

TEST(SourceTables, KeysComeAndGoAndCommentsStay) {
    EXPECT_EQ(with("kDoor",
                   [](auto &k) {
                       k.insert(k.begin() + 1, {8, 0.25f, 1});
                   }),
              replaced("// shut\n    {row", "// shut\n    {8, 0.25f, Smooth}, {row"));
    std::string without = with("kDoor", [](auto &k) { k.erase(k.begin() + 1); });
    EXPECT_EQ(without.find("0.8f"), std::string::npos);
    EXPECT_NE(without.find("// shut"), std::string::npos);
    EXPECT_NE(without.find("// ajar"), std::string::npos);
    for (int gone : {0, 2}) {
        std::string text = with("kDoor", [&](auto &k) { k.erase(k.begin() + gone); });
        EXPECT_NE(text.find("// shut"), std::string::npos) << text;
        EXPECT_NE(text.find("// ajar"), std::string::npos) << text;
    }
    with("kIn", [](auto &k) { k.push_back({200, 1, 2, 3, 4, 5, 6, 7, 50}); });
    with("kIn", [](auto &k) { k.insert(k.begin(), {-99, 1, 2, 3, 4, 5, 6, 7, 50}); });
    with("kGrow[0]", [](auto &k) { k.resize(1); });
}

TEST(SourceTables, AKeyThatACallMakesIsWrittenOut) {
    SourceTable table = tableOf(kFile, "kSink");
    std::vector<KeyNumbers> before = {{128, 1, 2, 3, 4, 5, 6, 7, 38}, {144, 1, 2, 3, 4, 5, 6, 7, 40}},
                            after = before;
    after[1][7] = 8;
    std::string text = withKeys(kFile, table, before, after);
    EXPECT_NE(text.find("around(128"), std::string::npos);
    after[0][1] = 1.5f;
    text = withKeys(text, tableOf(text, "kSink"), before, after);
    EXPECT_EQ(text.find("around(128"), std::string::npos);
    EXPECT_EQ(keysOf(text, tableOf(text, "kSink")), after);
}

TEST(SourceTables, AnyEditIsReadBack) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1e4f, 1e4f);
    for (int round = 0; round < 500; ++round)
        with(round % 2 ? "kIn" : "kDoor", [&](std::vector<KeyNumbers> &keys) {
            for (int n = (int)(random() % 4); n >= 0; --n) {
                size_t i = random() % keys.size(), k = random() % keys[0].size();
                float x = number(random) * std::pow(10.f, -(float)(random() % 8));
                if (keys[0].size() == 3 && k == 2) x = (float)(random() % 2);
                if (k == 0) x = (float)(int)x;
                switch (random() % 3) {
                case 0:
                    keys[i][k] = x;
                    break;
                case 1:
                    keys.insert(keys.begin() + (long)i, keys[i]);
                    keys[i][k] = x;
                    break;
                default:
                    if (keys.size() > 1) keys.erase(keys.begin() + (long)i);
                }
            }
        });
}

TEST(SourceTables, NumbersAreShortAndExact) {
    EXPECT_EQ(written(2), "2");
    EXPECT_EQ(written(-0.5f), "-0.5f");
    EXPECT_EQ(written(37.8f), "37.8f");
    EXPECT_EQ(written(1200), "1200");
    EXPECT_EQ(written(-0.f), "0");
    std::mt19937 random(1);
    for (int i = 0; i < 10000; ++i) {
        float x = std::ldexp((float)random(), -(int)(random() % 45));
        EXPECT_EQ(std::strtof(written(x).c_str(), nullptr), x) << written(x);
    }
}

TEST(SourceTables, GarbageIsNoTable) {
    for (const char *text :
         {"", "constexpr Key k[] = {", "constexpr Key k[] = {{", "constexpr Key k[] = {{1,2",
          "constexpr Key k[] = {}};", "constexpr auto k = coarse({/*", "constexpr Key k[][2] = {{{1",
          "constexpr Key k[] = {,};", "constexpr CameraKey k[] = {)"})
        for (const SourceTable &t : findTables(text)) EXPECT_TRUE(t.keys.empty()) << text;
    std::mt19937 random(3);
    for (int i = 0; i < 3000; ++i) {
        std::string text = kFile;
        for (int n = 0; n < 3; ++n) text[random() % text.size()] = "{}(),;/*"[random() % 8];
        text.resize(random() % text.size());
        findTables(text);
    }
}

// Of the film's own: what stands in the source is what the program has.
TEST(SourceTables, OfTheFilmAreThoseOfTheProgram) {
    Edits show(ODRAZ_SOURCE "/intro/show");
    std::set<std::vector<KeyNumbers>> paths;
    int tracks = 0;
    for (const EditedTable &t : show.tables()) {
        std::ifstream in(ODRAZ_SOURCE "/intro/show/" + t.file);
        std::string text{std::istreambuf_iterator<char>(in), {}};
        tracks += t.source.kind == TableKind::Track;
        EXPECT_FALSE(t.source.keys.empty()) << t.file << ' ' << t.source.name;
        if (t.source.kind == TableKind::Path && !t.source.keys[0].numbers.empty())
            paths.insert(keysOf(text, t.source));
    }
    EXPECT_GE(tracks, 25);
    int same = 0;
    for (int i = 0; i < kFilm.count; ++i) {
        CameraPath path = kFilm.shots[i].path;
        std::vector<KeyNumbers> keys;
        for (int k = 0; k < path.count; ++k) keys.push_back(numbersOf(path.keys[k]));
        same += (int)paths.count(keys);
    }
    EXPECT_GE(same, kFilm.count - 3); // one is made by around(), two by toTheDoor()
}

TEST(SourceEdits, AreUndoneAndDoneAgain) {
    Folder folder;
    Edits edits(folder.path);
    setBuilt(edits);
    int door = edits.find("scenes/one.cpp", "kDoor"), sink = edits.find("scenes/one.cpp", "kSink");
    ASSERT_GE(door, 0);
    EXPECT_EQ(edits.find("scenes/one.cpp", "kNone"), -1);
    EXPECT_FALSE(edits.change(sink, {{1, 1, 2, 3, 4, 5, 6, 7, 8}})) << "its keys are not known";
    EXPECT_FALSE(edits.change(door, {}));
    EXPECT_FALSE(edits.undo());
    std::vector<KeyNumbers> built = edits.tables()[(size_t)door].built;
    EXPECT_TRUE(edits.change(door, {{9, 1, 0}, {3, 0, 1}}));
    EXPECT_EQ(edits.tables()[(size_t)door].keys, (std::vector<KeyNumbers>{{3, 0, 1}, {9, 1, 0}}));
    EXPECT_TRUE(edits.change(door, {{5, 1, 0}}));
    EXPECT_EQ(edits.edited(), 1);
    EXPECT_TRUE(edits.undo());
    EXPECT_TRUE(edits.undo());
    EXPECT_FALSE(edits.undo());
    EXPECT_EQ(edits.tables()[(size_t)door].keys, built);
    EXPECT_EQ(edits.edited(), 0);
    EXPECT_TRUE(edits.redo());
    EXPECT_TRUE(edits.change(door, {{7, 1, 0}}));
    EXPECT_FALSE(edits.redo()) << "the step that was undone is gone";
}

TEST(SourceEdits, AreSavedAndSavedBack) {
    Folder folder;
    Edits edits(folder.path);
    setBuilt(edits);
    int door = edits.find("scenes/one.cpp", "kDoor"), grow = edits.find("scenes/one.cpp", "kGrow[1]");
    std::vector<KeyNumbers> keys = edits.tables()[(size_t)door].keys;
    keys[2][1] = 0.95f;
    edits.change(door, keys);
    edits.change(grow, {{3, 0.5f, 1}, {4, 1, 0}});
    EXPECT_EQ(edits.save(), "");
    std::string text = folder.text();
    EXPECT_NE(text.find("{72, 0.95f, Linear}"), std::string::npos) << text;
    EXPECT_NE(text.find("{{3, 0.5f, Smooth}, {4, 1, Linear}}"), std::string::npos) << text;
    EXPECT_EQ(edits.edited(), 0);
    edits.undo();
    edits.undo();
    EXPECT_EQ(edits.edited(), 2);
    EXPECT_EQ(edits.save(), "");
    EXPECT_EQ(folder.text(), kFile);
}

TEST(SourceEdits, AreNotSavedOverWhatOthersWrote) {
    Folder folder;
    Edits edits(folder.path);
    setBuilt(edits);
    int door = edits.find("scenes/one.cpp", "kDoor");
    edits.change(door, {{5, 1, 0}});
    std::ofstream(folder.file, std::ios::app) << "// mine\n";
    std::string theirs = folder.text();
    EXPECT_NE(edits.save().find("one.cpp was changed meanwhile"), std::string::npos);
    EXPECT_EQ(folder.text(), theirs);
    EXPECT_EQ(edits.edited(), 1);
    std::filesystem::remove(folder.file);
    EXPECT_NE(edits.save(), "");
    EXPECT_FALSE(std::filesystem::exists(folder.file));
    EXPECT_THROW(Edits(folder.path + "/nowhere"), std::runtime_error);
}
