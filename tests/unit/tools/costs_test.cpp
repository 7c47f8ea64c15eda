// Tests the table of what pictures cost.
#include "tools/common/arguments.h"
#include "tools/common/whole_file.h"
#include "tools/measure/seen/costs.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace odraz;

namespace {

constexpr char kHead[] = "seconds,kind,level,width,height,serial,parallel\n";

// A moment: all costs are multiples of `unit` millions.
std::string momentAt(double seconds, int unit) {
    std::string rows;
    auto add = [&](const char *kind, const char *level, const char *size, int serial, int parallel) {
        rows += std::to_string(seconds) + "," + kind + "," + level + "," + size + "," +
                std::to_string(serial * unit * 1000) + "," + std::to_string(parallel * unit * 1000) + "\n";
    };
    for (const char *size : {"640,360", "1280,720"}) {
        int more = size[0] == '1' ? 3 : 1;
        add("between", "2", size, 2, 30 * more);
        add("between", "1", size, 2, 40 * more);
        add("picture", "2", size, 1, 50 * more);
        add("picture", "1", size, 1, 100 * more);
    }
    add("picture", "0", "640,360", 1, 400);
    return rows;
}
// Two moments of the shot up to 16 s, one of the next, up to 24 s.
Costs sample() { return Costs(kHead + momentAt(4, 1) + momentAt(12, 2) + momentAt(20, 7)); }
constexpr double kSmall = 640 * 360, kLarge = 1280 * 720;

TEST(Costs, AreThoseCounted) {
    Costs costs = sample();
    EXPECT_NEAR(costs.of({4, 1, kSmall, false}).parallel, 100e6, 1);
    EXPECT_NEAR(costs.of({4, 1, kLarge, false}).parallel, 300e6, 1);
    EXPECT_NEAR(costs.of({12, 2, kLarge, false}).parallel, 300e6, 1);
    EXPECT_NEAR(costs.of({4, 2, kSmall, true}).parallel, 30e6, 1);
    EXPECT_NEAR(costs.of({4, 2, kSmall, true}).serial, 2e6, 1);
}

TEST(Costs, AreInterpolated) {
    Costs costs = sample();
    EXPECT_NEAR(costs.of({8, 1, kSmall, false}).parallel, 150e6, 1) << "time, linear";
    EXPECT_NEAR(costs.of({4, 1.5f, kSmall, false}).parallel, 100e6 / std::sqrt(2.), 1)
        << "level, by logarithm";
    EXPECT_NEAR(costs.of({4, 0.5f, kSmall, false}).parallel, 200e6, 1);
    EXPECT_NEAR(costs.of({4, 1, 2 * kSmall, false}).parallel, 100e6 * std::sqrt(3.), 1) << "pixels, a power";
    EXPECT_NEAR(costs.of({4, 1, 4 * kLarge, false}).parallel, 900e6, 1) << "... and beyond";
    EXPECT_NEAR(costs.of({4, 1, 4 * kLarge, false}).serial, 1e6, 1);
    EXPECT_NEAR(costs.of({4, 0, kLarge, false}).parallel, 1200e6, 1)
        << "a level of one size grows as play does";
    EXPECT_NEAR(costs.of({4, 0.2f, kSmall, true}).parallel, 40e6, 1) << "beyond the best one counted";
}

TEST(Costs, NeverCrossACut) {
    Costs costs = sample();
    EXPECT_NEAR(costs.of({0, 1, kSmall, false}).parallel, 100e6, 1);
    EXPECT_NEAR(costs.of({15.9, 1, kSmall, false}).parallel, 200e6, 1);
    EXPECT_NEAR(costs.of({16.1, 1, kSmall, false}).parallel, 700e6, 1);
    EXPECT_THROW(costs.of({30, 1, kSmall, false}), Refused);
}

TEST(Costs, WhatIsWrongIsTold) {
    auto wrongIn = [](const std::string &text) -> std::string {
        try {
            Costs costs(text);
        } catch (const Refused &why) {
            return why.what();
        }
        return "";
    };
    std::string good = kHead + momentAt(20, 1);
    EXPECT_EQ(wrongIn(good), "");
    EXPECT_EQ(wrongIn("seconds\n").substr(0, 7), "line 1:");
    EXPECT_EQ(wrongIn(good + "1\n").substr(0, 8), "line 11:");
    for (const char *row : {"20,made,1,64,36,1,1", "20,picture,3,64,36,1,1", "20,picture,play,64,36,1,1",
                            "20,picture,1,0,36,1,1", "20,picture,1,64,36,-1,1", "20,picture,1,64,36,1,nan",
                            "1,picture,1,64,36,1,1", "1e9,picture,1,64,36,1,1", "20,picture,1,64,36,1,1,1"})
        EXPECT_NE(wrongIn(good + row + "\n"), "") << row;
    EXPECT_NE(wrongIn(good + "30,picture,1,64,36,1,1\n"), "") << "too few counts";
}

// The table that the repository has is whole.
TEST(Costs, EveryMomentOfTheFilmIsCounted) {
    Costs costs(readWhole(kCostsFile));
    for (double s = 0; s < 162; s += 0.25) {
        double last = 1e18;
        for (float level : {0.1f, 1.f, 1.5f, 2.f}) {
            Cost c = costs.of({s, level, kLarge, false});
            EXPECT_LT(c.parallel, last) << s << ' ' << level;
            EXPECT_LT(c.serial, 0.2 * c.parallel) << s << ' ' << level;
            last = c.parallel;
        }
        EXPECT_GT(costs.of({s, 1.5f, kLarge, true}).parallel, 1e6);
    }
}

} // namespace
