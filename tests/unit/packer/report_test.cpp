#include "packer/options.h"
#include "packer/report/report_html.h"
#include "tests/support/thrown.h"

using namespace pack;

// Returns the first letter of the claim of each byte; '.' for none.
static std::string text(std::vector<Claim> claims) {
    std::string all;
    for (uint32_t i : assignClaims(claims, 0, 10)) all += i == kUnclaimed ? '.' : claims[i].name[0];
    return all;
}

// Makes a report of bytes with these costs, in two sections, two objects and three symbols.
static Report example(std::vector<float> bits, const Rooms *rooms = nullptr) {
    std::vector<Stretch> stretches = {{0, 2, ".text", "a.o", "liba.a", "f(int)"},
                                      {2, 1, ".text", "a.o", "liba.a", "(nothing named in .text)"},
                                      {3, 1, ".data", "b.o", "src", "g"}};
    double all = std::accumulate(bits.begin(), bits.end(), 0.);
    return makeReport(stretches, bits, 100 + (size_t)(all / 8) + 2, 100, rooms);
}

// Whether the text is read as a report and not refused.
static bool reads(const std::string &text) {
    return thrown<common::Refused>([&] { readJson(text); }).empty();
}

// --- The symbol of each byte ---

TEST(Attribution, GivesEachByteToOneClaim) {
    EXPECT_EQ(text({}), "..........");
    EXPECT_EQ(text({{5, 9, "b"}, {0, 4, "a"}}), "aaaa.bbbb.");
    EXPECT_EQ(text({{0, 10, "out"}, {3, 5, "in"}}), "oooiiooooo"); // nested
    EXPECT_EQ(text({{0, 6, "a"}, {4, 9, "b"}}), "aaaabbbbb.");     // partly
    EXPECT_EQ(text({{0, 4, "z"}, {0, 4, "alias"}}), "aaaa......"); // the same
    EXPECT_EQ(text({{0, 8, "long"}, {0, 3, "short"}}), "ssslllll..");
    EXPECT_EQ(text({{2, 4, "b"}, {0, 9, "a"}, {3, 6, "c"}}), "aabcccaaa.");
    std::vector<Claim> outside = {{0, 90, "a"}, {20, 30, "b"}, {95, UINT64_MAX, "c"}};
    EXPECT_EQ(assignClaims(outside, 25, 10), (std::vector<uint32_t>{1, 1, 1, 1, 1, 0, 0, 0, 0, 0}));
}

TEST(Attribution, FindsObjectAndArchiveInPaths) {
    auto both = [](const std::string &path) {
        Origin origin = originOf(path);
        return origin.object + " in " + origin.room;
    };
    EXPECT_EQ(both("lib/x86/libc.a(printf.o)"), "printf.o in libc.a");
    EXPECT_EQ(both("src/main.o"), "main.o in src");
    EXPECT_EQ(both("main.o"), "main.o in .");
    EXPECT_EQ(both("odd(name"), "odd(name in .");
}

// --- Costs (test_report.py adds them up) ---

TEST(Report, KeepsRangesOfCheapBytesExact) {
    std::vector<float> bits(16000, 0.01f); // each rounds to nothing, all together to 160 bits
    Report r = makeReport({{0, 16000, ".text", "", "", "f"}}, bits, 21, 1);
    EXPECT_NEAR(r.sections[".text"].bits, 160, 0.1);
    EXPECT_TRUE(r.objects.empty() && r.rooms.empty());
}

TEST(Report, GroupsObjectsByRooms) {
    Rooms rooms = readRooms("# a comment\n\nhall 10 a.o c.o\nstub - (stub)\n");
    EXPECT_EQ(rooms.shares.at("hall"), 10);
    EXPECT_EQ(rooms.shares.count("stub"), 0u);
    Report r = example({8, 8, 8, 8}, &rooms);
    EXPECT_EQ(r.rooms.at("hall").bits, 24);
    EXPECT_EQ(r.rooms.at(kNothingNamed).bits, 8); // b.o
    EXPECT_EQ(r.stubRoom, "stub");
    EXPECT_EQ(r.roomOf.at("c.o"), "hall"); // an object that only earlier builds may have
    for (const char *wrong : {"hall\n", "hall ten a.o\n", "hall -5 a.o\n", "hall 5x\n"})
        EXPECT_THROW(readRooms(wrong), common::Refused) << wrong;
}

// --- JSON ---

TEST(Json, ReadsNamesWithAnyCharacters) {
    Report r = makeReport({{0, 1, ".text", "a \"b\" \\ c\n.o", "ž", "operator<<(x, y)\x01"}}, {8}, 11, 10);
    Report read = readJson(printJson(r));
    EXPECT_EQ(read.objects.begin()->first, "a \"b\" \\ c\n.o");
    EXPECT_EQ(read.roomOf.begin()->second, "ž");
    EXPECT_EQ(read.symbols.begin()->first, "operator<<(x, y)\x01");
}

TEST(Json, ReadsEarlierReportsAndLaterOnes) {
    // A report of a ledger, without symbols, and with members of a later version
    Report r = readJson("{\"file\": 20, \"overhead\": 10, \"later\": {\"x\": {\"y\": \"z\"}},\n"
                        "\"sections\": {\".text\": {\"bytes\": 9, \"bits\": 80}}, \"objects\": {\n"
                        "\"cc7sCLLD.ltrans0.ltrans.o\": {\"bytes\": 9, \"bits\": 80, \"more\": 1}}}");
    EXPECT_EQ(r.fileSize, 20u);
    EXPECT_EQ(r.objects.at("(optimised as a whole)").bits, 80);
}

TEST(Json, RefusesOtherTexts) {
    const std::string good = printJson(example({1, 2, 3, 4}));
    EXPECT_TRUE(reads(good));
    for (const std::string wrong :
         {"", "{}", "[]", "text", "{\"file\": 5}", "{\"file\": nan, \"overhead\": 0}"})
        EXPECT_FALSE(reads(wrong)) << wrong;
    EXPECT_FALSE(reads(good + "x"));
    EXPECT_FALSE(reads(good + std::string(1, 0)));
    std::string deep;
    for (int i = 0; i < 100000; ++i) deep += "{\"a\":";
    EXPECT_FALSE(reads(deep));
    for (size_t size = 0; size + 1 < good.size(); ++size) EXPECT_FALSE(reads(good.substr(0, size))) << size;
    // Random changes are read or refused
    std::mt19937 random(3);
    for (int round = 0; round < 20000; ++round) {
        std::string changed = good;
        for (int n = 1 + (int)(random() % 3); n--;)
            changed[random() % changed.size()] =
                (char)(random() % 4 ? "{}\":,\\u0e-"[random() % 10] : random());
        reads(changed);
    }
}

// --- A comment on a change ---

TEST(Markdown, HasTotalBudgetAndLargestChanges) {
    Report before = example({8, 8, 8, 8}), now = example({80, 8, 8, 8});
    std::string text = printMarkdown("a|b", now, &before, 120);
    EXPECT_NE(text.find("**`a/b`: 115 bytes**, +9 (+8.49 %), 5 left of 120\n"), std::string::npos) << text;
    EXPECT_NE(text.find("|       +9 |       11 |        2 | `f(int)` |\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("`g`"), std::string::npos) << text; // did not change
    EXPECT_NE(printMarkdown("a", now, &before, 110).find("**over budget by 5** of 110"), std::string::npos);
    EXPECT_NE(printMarkdown("a", now, &now, -1).find("No symbol changed by four bytes or more."),
              std::string::npos);
    EXPECT_NE(printMarkdown("a", now, nullptr, -1).find("|      100 | `(stub)` |"), std::string::npos);
    // A symbol that no longer exists, and a report without symbols
    before.symbols["old"].bits = 16000;
    EXPECT_NE(printMarkdown("a", now, &before, -1).find("|   -2,000 |        0 |    2,000 | `old` |"),
              std::string::npos);
    before.symbols.clear();
    EXPECT_NE(printMarkdown("a", now, &before, -1).find("| `a.o` |"), std::string::npos);
    EXPECT_EQ(printMarkdown("a", now, &before, -1).find("f(int)"), std::string::npos);
}

TEST(Markdown, HasTenLinesAtMost) {
    Report now = example({8, 8, 8, 8});
    for (int i = 0; i < 30; ++i) now.symbols["s" + std::to_string(i)].bits = 8000;
    std::string text = printMarkdown("a", now, nullptr, -1);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 + 2 + 10);
}

TEST(Markdown, ComparesRoomsOfRemovedObjects) {
    Report before = example({8, 8, 8, 8}), now = example({8, 8, 8, 8});
    before.objects["gone.o"].bits = 80;
    before.roomOf["gone.o"] = "attic";
    before.roomOf["a.o"] = "elsewhere"; // it has moved
    arrange(before, now);
    EXPECT_EQ(before.rooms.at("attic").bits, 80);
    EXPECT_EQ(before.rooms.at("liba.a").bits, 24);
}

// --- The command line ---

TEST(Options, RefusesContradictions) {
    auto why = [](const std::vector<std::string> &words) {
        return thrown<common::Refused>([&] {
            common::CommandLine line("pack", words);
            parseOptions(line);
        });
    };
    const struct {
        std::vector<std::string> words;
        const char *text;
    } kWrong[] = {
        {{}, "it takes IN -o OUT"},
        {{"in"}, "it takes IN -o OUT"},
        {{"in", "-o", "out", "--test", "in"}, "it takes IN -o OUT"},
        {{"--test", "in", "--budget", "1"}, "--budget is only for packing"},
        {{"-d", "in", "-o", "out", "--plain"}, "--plain is only for packing"},
        {{"in", "-o", "out", "--budget", "64k"}, "--budget needs a number of bytes, or none, not '64k'"},
        {{"in", "-o", "out", "--budget", "1.5"}, "--budget needs"},
        {{"in", "-o", "out", "--effort", "more"}, "--effort needs fast, normal, best or a number of seconds"},
        {{"in", "-o", "out", "--loader", "--pe"}, "--loader is for Linux, --pe for Windows"},
        {{"in", "-o", "out", "--fast", "--model", "x"}, "--fast and --model both choose contexts"},
        {{"in", "-o", "out", "--symbols", "x"}, "--symbols needs --map"},
        {{"in", "-o", "out", "--rooms", "x"}, "--rooms needs --map"},
        {{"in", "-o", "out", "--than", "x"}, "--than needs --html or --text"},
        {{"in", "-o", "./in"}, "in would be overwritten"},
        {{"in", "-o", "out", "--html", "out"}, "out is used for two outputs"},
        {{"in", "-o", "out", "--model", "none"}, "cannot read none"},
    };
    for (auto &wrong : kWrong)
        EXPECT_NE(why(wrong.words).find(wrong.text), std::string::npos) << why(wrong.words);
    EXPECT_EQ(why({"in", "-o", "out", "--budget", "none", "--effort", "0"}), "");
}
