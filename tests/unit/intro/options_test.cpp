#include "options.h"

using namespace odraz;

static bool parse(std::vector<const char *> args, Options &o, Message &wrong) {
    args.insert(args.begin(), "odraz");
    return parseOptions((int)args.size(), args.data(), 164, o, wrong);
}

static Options good(std::vector<const char *> args) {
    Options o;
    Message wrong;
    EXPECT_TRUE(parse(args, o, wrong)) << wrong.data;
    return o;
}

// Parses a command line of words separated by single spaces and expects an error. Returns the error line.
static std::string bad(std::string line) {
    std::vector<const char *> args = {line.data()};
    for (char &c : line)
        if (c == ' ') c = 0, args.push_back(&c + 1);
    Options o;
    Message wrong;
    EXPECT_FALSE(parse(args, o, wrong)) << line;
    return wrong.size ? wrong.data : "";
}

static int64_t first(const char *from, const char *fps) {
    Options o = good({"--dump", "x", "--from", from, "--fps", fps});
    return firstFrame(o.from, o.fps);
}

TEST(Options, DefaultsPlayTheWholeFilm) {
    Options o = good({});
    EXPECT_EQ(o.dump, nullptr);
    EXPECT_EQ(o.width, 1280);
    EXPECT_EQ(o.quality, QualityName::Count);
    EXPECT_EQ(firstFrame(o.to, {25, 1}), 164 * 25);
}

TEST(Options, ReadsEveryOption) {
    Options o = good({"--dump", "-", "--fps", "30000/1001", "--from", "1.5", "--to", "2.25", "--size",
                      "7680x4320", "--quality", "reference", "--threads", "64"});
    EXPECT_STREQ(o.dump, "-");
    EXPECT_EQ(o.fps.numerator, 30000);
    EXPECT_EQ(o.fps.denominator, 1001);
    EXPECT_EQ(o.width, 7680);
    EXPECT_EQ(o.height, 4320);
    EXPECT_EQ(o.quality, QualityName::Reference);
    EXPECT_EQ(o.threads, 64);
    EXPECT_TRUE(good({"--dump", "x", "--quality", "live", "--fps", "60"}).live);
    EXPECT_TRUE(good({"--dump", "x", "--fps", "120/2", "--quality", "live"}).live);
    EXPECT_FALSE(good({"--dump", "x", "--quality", "live", "--quality", "film"}).live);
    EXPECT_TRUE(good({"--window", "--stats"}).window);
    EXPECT_STREQ(good({"--wav", "film.wav", "--from", "2"}).wav, "film.wav");
    EXPECT_STREQ(good({"--wav", "-", "--dump", "frames"}).wav, "-");
    o = good({"--dump=a=b", "--from=2", "--size=64x36", "--to", "3"});
    EXPECT_STREQ(o.dump, "a=b");
    EXPECT_EQ(seconds(o.from), 2);
    EXPECT_EQ(seconds(o.to), 3);
    EXPECT_EQ(o.width, 64);
    EXPECT_TRUE(good({"-h"}).help && good({"--help"}).help);
}

TEST(Options, ReportsWhatIsWrongInALine) {
    EXPECT_NE(bad("--wav").find("--wav needs a file"), std::string::npos);
    EXPECT_NE(bad("--wav - --dump -").find("name a file"), std::string::npos);
    EXPECT_NE(bad("--wav x --window").find("--window is for playing"), std::string::npos);
    for (const char *line : {"--quality live", "--quality live --fps 60", "--dump x --quality live",
                             "--dump x --quality live --fps 60000/1001"})
        EXPECT_NE(bad(line).find("--quality live is for --dump with --fps 60"), std::string::npos) << line;
    EXPECT_EQ(bad("--to=x"), "--to needs seconds, like 12.5, not 'x'");
    EXPECT_NE(bad("--frames").find("--frames"), std::string::npos);
    EXPECT_NE(bad("--quality best").find("draft, play, film, reference or live, not 'best'"),
              std::string::npos);
    for (const char *line : {"film", "--fps", "--from 3 --to 2", "--dump", "--dump ", "--dump x --window",
                             "--dump x --stats", "--dump=", "--mute=1", "--dumps=x", "--d=x", ""})
        EXPECT_FALSE(bad(line).empty()) << line;
    const std::pair<std::string, const char *> kBadValues[] = {
        {"--fps ", "0 -1 1e3 25/0 25/ 2000 1/2000 99999999999999999999"},
        {"--from ", "1,5 . 1. -1 1.1234567"},
        {"--to ", "165"},
        {"--size ", "0x5 5 5x 5x5x5 7681x1 1x4321"},
        {"--threads ", "0 65 two"},
    };
    for (auto &[option, all] : kBadValues) {
        std::istringstream values(all);
        for (std::string value; values >> value;)
            EXPECT_FALSE(bad(option + value).empty()) << option << value;
    }
}

TEST(Options, LongRubbishIsCutOff) { EXPECT_LT(bad(std::string(5000, 'x')).size(), 256u); }

// Decimals and rates are exact: frame n is in [from, to) if from <= n / fps < to.
TEST(Frames, AreCountedExactly) {
    EXPECT_EQ(first("0", "25"), 0);
    EXPECT_EQ(first("1", "25"), 25);
    EXPECT_EQ(first("0.04", "25"), 1);
    EXPECT_EQ(first("0.040001", "25"), 2);
    EXPECT_EQ(first("0.1", "10"), 1);
    EXPECT_EQ(first("0.3", "10"), 3); // binary numbers cannot represent 0.3
    EXPECT_EQ(first("1.001", "30000/1001"), 30);
    EXPECT_EQ(first("163.999999", "1000"), 164000);
    EXPECT_EQ(first("10", "23.976"), 240);
}

TEST(Frames, ShardsJoinWithoutGapOrOverlap) {
    for (const char *fps : {"25", "30000/1001", "7", "1/3", "59.94"}) {
        Options whole = good({"--fps", fps});
        int64_t next = 0;
        for (int i = 0; i < 164; ++i) {
            Options shard = good(
                {"--fps", fps, "--from", std::to_string(i).c_str(), "--to", std::to_string(i + 1).c_str()});
            EXPECT_EQ(firstFrame(shard.from, shard.fps), next);
            next = firstFrame(shard.to, shard.fps);
        }
        EXPECT_EQ(next, firstFrame(whole.to, whole.fps));
    }
}

TEST(Frames, TimeIsTheQuotient) {
    EXPECT_EQ(frameTime(30, {30000, 1001}), 1.001);
    EXPECT_EQ(frameTime(0, {25, 1}), 0);
}
