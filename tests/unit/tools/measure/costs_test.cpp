// Tests the table of the costs of pictures.
#include "tests/support/thrown.h"
#include "tools/common/command_line.h"
#include "tools/common/whole_file.h"
#include "tools/measure/play/costs.h"

using namespace odraz;
using namespace odraz::measure;

constexpr char kHead[] = "seconds,gap,level,width,height,serial,parallel\n";

// The rows of a moment, whose costs are multiples of `unit` millions.
static std::string momentAt(double seconds, int unit) {
    std::string rows;
    auto add = [&](const char *gap, const char *level, const char *size, int serial, int parallel) {
        rows += std::to_string(seconds) + "," + gap + "," + level + "," + size + "," +
                std::to_string(serial * unit * 1000) + "," + std::to_string(parallel * unit * 1000) + "\n";
    };
    for (const char *size : {"640,360", "1280,720"}) {
        int more = size[0] == '1' ? 3 : 1;
        add("2", "2", size, 2, 30 * more);
        add("2", "1", size, 2, 40 * more);
        add("4", "1", size, 3, 48 * more);
        add("0", "2", size, 1, 50 * more);
        add("0", "1", size, 1, 100 * more);
    }
    add("0", "0", "640,360", 1, 400);
    return rows;
}
// One moment of the shot that ends at 148 s, and two of the last shot.
static PictureCosts sample() {
    return PictureCosts(kHead + momentAt(144, 7) + momentAt(150, 1) + momentAt(158, 2));
}
constexpr double kSmall = 640 * 360, kLarge = 1280 * 720;

TEST(PictureCosts, AreTheCountedOnes) {
    PictureCosts costs = sample();
    EXPECT_NEAR(costs.of({150, 1, kSmall, 0}).parallel, 100e6, 1);
    EXPECT_NEAR(costs.of({150, 1, kLarge, 0}).parallel, 300e6, 1);
    EXPECT_NEAR(costs.of({158, 2, kLarge, 0}).parallel, 300e6, 1);
    EXPECT_NEAR(costs.of({150, 2, kSmall, 2}).parallel, 30e6, 1);
    EXPECT_NEAR(costs.of({150, 2, kSmall, 2}).serial, 2e6, 1);
}

TEST(PictureCosts, AreInterpolated) {
    PictureCosts costs = sample();
    EXPECT_NEAR(costs.of({154, 1, kSmall, 0}).parallel, 150e6, 1) << "time, linear";
    EXPECT_NEAR(costs.of({150, 1.5f, kSmall, 0}).parallel, 100e6 / std::sqrt(2.), 1) << "level, by logarithm";
    EXPECT_NEAR(costs.of({150, 0.5f, kSmall, 0}).parallel, 200e6, 1);
    EXPECT_NEAR(costs.of({150, 1, 2 * kSmall, 0}).parallel, 100e6 * std::sqrt(3.), 1) << "pixels, a power";
    EXPECT_NEAR(costs.of({150, 1, 4 * kLarge, 0}).parallel, 900e6, 1) << "... and beyond";
    EXPECT_NEAR(costs.of({150, 1, 4 * kLarge, 0}).serial, 1e6, 1);
    EXPECT_NEAR(costs.of({150, 0, kLarge, 0}).parallel, 1200e6, 1)
        << "a level of one size grows as play does";
    EXPECT_NEAR(costs.of({150, 0.2f, kSmall, 2}).parallel, 40e6, 1) << "beyond the best one counted";
}

// The cost of an in-between depends on its gap.
TEST(PictureCosts, OfInBetweensDependOnTheirGap) {
    PictureCosts costs = sample();
    auto parallel = [&](double gap) { return costs.of({150, 1, kSmall, gap}).parallel; };
    EXPECT_NEAR(parallel(2), 40e6, 1);
    EXPECT_NEAR(parallel(4), 48e6, 1);
    EXPECT_NEAR(parallel(3), 44e6, 1) << "linear";
    EXPECT_NEAR(parallel(6), 48e6, 1) << "the nearest, beyond those counted";
    EXPECT_NEAR(parallel(1.5), 40e6, 1) << "... not mixed with a traced picture's";
    EXPECT_NEAR(costs.of({150, 2, kSmall, 4}).parallel, 48e6, 1)
        << "a level that was not counted at that gap";
    EXPECT_NEAR(costs.of({150, 2, kSmall, 3}).parallel, 39e6, 1) << "... each gap has its own levels";
    EXPECT_NEAR(costs.of({154, 1, kSmall, 4}).parallel, 72e6, 1) << "time, too";
}

TEST(PictureCosts, NeverCrossACut) {
    PictureCosts costs = sample();
    EXPECT_NEAR(costs.of({148.5, 1, kSmall, 0}).parallel, 100e6, 1);
    EXPECT_NEAR(costs.of({163.9, 1, kSmall, 0}).parallel, 200e6, 1);
    EXPECT_NEAR(costs.of({147.9, 1, kSmall, 0}).parallel, 700e6, 1);
    EXPECT_THROW(costs.of({100, 1, kSmall, 0}), common::Refused);
}

TEST(PictureCosts, WhatIsWrongIsReported) {
    auto wrongIn = [](const std::string &text) {
        return thrown<common::Refused>([&] { PictureCosts costs(text); });
    };
    std::string good = kHead + momentAt(20, 1);
    EXPECT_EQ(wrongIn(good), "");
    EXPECT_EQ(wrongIn("seconds\n").substr(0, 7), "line 1:");
    EXPECT_EQ(wrongIn(good + "1\n").substr(0, 8), "line 13:");
    for (const char *row :
         {"20,picture,1,64,36,1,1", "20,-2,1,64,36,1,1", "20,0.5,1,64,36,1,1", "20,61,1,64,36,1,1",
          "20,nan,1,64,36,1,1", "20,0,3,64,36,1,1", "20,0,play,64,36,1,1", "20,0,1,0,36,1,1",
          "20,0,1,64,36,-1,1", "20,0,1,64,36,1,nan", "1,0,1,64,36,1,1", "1e9,0,1,64,36,1,1",
          "20,0,1,64,36,1,1,1"})
        EXPECT_EQ(wrongIn(good + row + "\n").substr(0, 8), "line 13:") << row;
    // Too few counts
    EXPECT_NE(wrongIn(good + "20,6,1,64,36,1,1\n"), "") << "one size of a gap";
    std::string traced = "30,0,1,640,360,1,1\n30,0,1,1280,720,1,1\n";
    EXPECT_NE(wrongIn(good + traced), "") << "no in-between";
    EXPECT_EQ(wrongIn(good + traced + "30,2,1,640,360,1,1\n30,2,1,1280,720,1,1\n"), "");
}

// The repository's table is complete.
TEST(PictureCosts, EveryMomentOfTheFilmIsCounted) {
    PictureCosts costs(common::readWhole(kCostsFile));
    for (double s = 0; s < 164; s += 0.25) {
        double last = 1e18;
        for (float level : {0.1f, 1.f, 1.5f, 2.f}) {
            PictureCost c = costs.of({s, level, kLarge, 0});
            EXPECT_LT(c.parallel, last) << s << ' ' << level;
            EXPECT_LT(c.serial, 0.2 * c.parallel) << s << ' ' << level;
            last = c.parallel;
        }
        for (double gap : {2, 4, 6}) EXPECT_GT(costs.of({s, 1.5f, kLarge, gap}).parallel, 1e6);
    }
}
