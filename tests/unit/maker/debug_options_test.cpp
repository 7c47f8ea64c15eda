#include "maker/debug_options.h"

using namespace odraz;
using namespace odraz::maker;

struct Parsed {
    explicit Parsed(std::vector<std::string> line) {
        line.insert(line.begin(), "odraz-debug");
        std::vector<char *> argv;
        for (std::string &word : line) argv.push_back(word.data());
        argv.push_back(nullptr);
        int argc = (int)line.size();
        wrong = takeOptions(argc, argv.data(), options);
        for (int i = 1; wrong.empty() && i < argc; ++i) rest += std::string(argv[(size_t)i]) + " ";
        shown = options.shown ? options.shown : "";
    }
    DebugOptions options;
    std::string wrong, rest, shown;
};

TEST(DebugOptions, RemovesItsOptions) {
    Parsed t({"--from", "3", "--shown", "list", "--mute"});
    EXPECT_EQ(t.shown, "list");
    EXPECT_EQ(t.rest, "--from 3 --mute ");
    EXPECT_NE(Parsed({"--shown"}).wrong.find("needs a file"), std::string::npos);
    EXPECT_NE(Parsed({"--tracks", "a", "--rocket"}).wrong.find("use only one"), std::string::npos);
}

TEST(DebugOptions, ParsesHosts) {
    auto at = [](const char *host) {
        Parsed t({"--rocket", host});
        return t.wrong.empty() ? t.options.host + " " + std::to_string(t.options.port) : "";
    };
    EXPECT_EQ(at("desk"), "desk 1338");
    EXPECT_EQ(at("desk:7"), "desk 7");
    EXPECT_EQ(at("::1"), "::1 1338");
    EXPECT_EQ(at("[::1]"), "::1 1338");
    EXPECT_EQ(at("[::1]:65535"), "::1 65535");
    for (const char *bad :
         {"desk:", "desk:0", "desk:65536", "desk:7x", "desk:-7", ":7", "[]", "[::1", "[::1]7"})
        EXPECT_EQ(at(bad), "") << bad;
    Parsed none({"--rocket", "--mute"});
    EXPECT_EQ(none.options.host, "localhost");
    EXPECT_EQ(none.rest, "--mute ");
}
