#include "maker/panel/keys.h"
#include "maker/panel/steps.h"
#include "maker/panel/strip.h"

#include <cctype>

using namespace odraz;
using namespace odraz::maker;

// --- Steps and loops ---

TEST(Steps, VisitEveryPictureOnceAndComeBack) {
    constexpr double kEnd = 164;
    for (double rate : {24., 25., 30., 59.94, 60.}) {
        int last = (int)(kEnd * rate);
        double t = 0;
        for (int i = 1; i < last; ++i) {
            t = stepBy(t, 1 / rate, 1, kEnd);
            ASSERT_NEAR(t, i / rate, 1e-9) << rate;
        }
        for (int i = last - 2; i >= 0; --i) {
            t = stepBy(t, 1 / rate, -1, kEnd);
            ASSERT_NEAR(t, i / rate, 1e-9) << rate;
        }
    }
}

TEST(Steps, GoToTheNearestMultipleFromBetween) {
    EXPECT_DOUBLE_EQ(stepBy(3.1, 2, 1, 10), 4);
    EXPECT_DOUBLE_EQ(stepBy(3.1, 2, -1, 10), 2);
    EXPECT_DOUBLE_EQ(stepBy(4, 2, -1, 10), 2);
    EXPECT_DOUBLE_EQ(stepBy(9.5, 2, 1, 9.7), 9.7);
    EXPECT_DOUBLE_EQ(stepBy(0, 2, -1, 10), 0);
}

TEST(Steps, GoFromEventToEvent) {
    std::vector<double> times = {1, 2, 2, 5};
    EXPECT_EQ(stepTo(0, times, 1), 1);
    EXPECT_EQ(stepTo(1, times, 1), 2);
    EXPECT_EQ(stepTo(2, times, 1), 5);
    EXPECT_EQ(stepTo(5, times, 1), 5);
    EXPECT_EQ(stepTo(5, times, -1), 2);
    EXPECT_EQ(stepTo(2, times, -1), 1);
    EXPECT_EQ(stepTo(1, times, -1), 1);
    EXPECT_EQ(stepTo(3, {}, 1), 3);
}

TEST(Loops, ReachOverWholeBeatsAndAreLongEnoughForTheMusic) {
    Loop l = loopBetween(10.2, 14.1, 100);
    EXPECT_DOUBLE_EQ(l.from, 10);
    EXPECT_DOUBLE_EQ(l.to, 14.5);
    Loop back = loopBetween(14.1, 10.2, 100);
    EXPECT_EQ(back.from, l.from);
    EXPECT_EQ(back.to, l.to);
    for (double a : {0., 0.1, 50., 99.9, 100.}) {
        Loop least = loopBetween(a, a, 100);
        EXPECT_GE(least.to - least.from, kShortestLoop) << a;
        EXPECT_GE(least.from, 0);
        EXPECT_LE(least.to, 100);
    }
    EXPECT_FALSE(loopBetween(0, 1, 1).on());
}

// --- The strip ---

TEST(Strip, LiesAlongTheLowerEdge) {
    for (auto [width, height] : {std::pair{640, 360}, {1280, 720}, {1920, 1080}, {3840, 2160}}) {
        Strip s = stripOf(width, height, 164);
        EXPECT_EQ(s.area.bottom(), height);
        EXPECT_EQ(s.area.width, width);
        EXPECT_GT(s.area.height, 20);
        EXPECT_LT(s.area.height, height / 4);
    }
    EXPECT_EQ(stripOf(64, 36, 164).area.height, 0);
    EXPECT_FALSE(stripOf(64, 36, 164).area.holds(10, 36));
}

TEST(Strip, HasATimeForEveryPixel) {
    Strip s = stripOf(1280, 720, 164);
    EXPECT_EQ(s.timeAt(0), 0);
    EXPECT_NEAR(s.timeAt(640), 82, 1e-9);
    EXPECT_EQ(s.timeAt(1280), 164);
    EXPECT_EQ(s.timeAt(-50), 0);
    EXPECT_EQ(s.timeAt(2000), 164);
    s.zoom(300, 0.1);
    for (double x : {0., 77.5, 300., 1279.}) EXPECT_NEAR(s.xOf(s.timeAt(x)), x, 1e-6);
}

TEST(Strip, StretchesAboutThePointer) {
    Strip s = stripOf(1280, 720, 164);
    double at = s.timeAt(900);
    s.zoom(900, 0.5);
    EXPECT_NEAR(s.timeAt(900), at, 1e-9);
    EXPECT_NEAR(s.to - s.from, 82, 1e-9);
    for (int i = 0; i < 50; ++i) s.zoom(900, 0.5);
    EXPECT_NEAR(s.to - s.from, 2, 1e-9);
    EXPECT_NEAR(s.timeAt(900), at, 1e-6);
    for (int i = 0; i < 50; ++i) s.zoom(10, 2);
    EXPECT_EQ(s.from, 0);
    EXPECT_EQ(s.to, 164);
}

TEST(Strip, FollowsTheTimeShown) {
    Strip s = stripOf(1280, 720, 164);
    s.zoom(0, 0.1);
    s.follow(10);
    EXPECT_EQ(s.from, 0);
    for (double t : {100., 164., 3., 0.}) {
        s.follow(t);
        EXPECT_LE(s.from, t);
        EXPECT_GE(s.to, t);
        EXPECT_GE(s.from, 0);
        EXPECT_LE(s.to, 164);
        EXPECT_NEAR(s.to - s.from, 16.4, 1e-9);
    }
}

TEST(Strip, FindsTheEventUnderThePointer) {
    Content c;
    c.end = 100;
    c.events = {{10, 0, true, "one"}, {11, 0, false, "two"}, {50, 0, true, "three"}};
    Strip s = stripOf(1000, 600, 100); // ten pixels a second
    EXPECT_STREQ(eventNear(s, c, 101)->name, "one");
    EXPECT_STREQ(eventNear(s, c, 108)->name, "two");
    EXPECT_EQ(eventNear(s, c, 300), nullptr);
}

TEST(Content, HasTheShotOfATime) {
    Content c;
    c.shots = {{0, 5, 0, 0, {}}, {5, 9, 0, 1, {}}, {9, 20, 9, 1, {}}};
    EXPECT_EQ(&c.shotAt(-1), &c.shots[0]);
    EXPECT_EQ(&c.shotAt(4.99), &c.shots[0]);
    EXPECT_EQ(&c.shotAt(5), &c.shots[1]);
    EXPECT_EQ(&c.shotAt(30), &c.shots[2]);
}

// --- Keys ---

TEST(Keys, HaveOneMeaningEachAndEveryActionHasOne) {
    bool has[(int)Action::Count] = {};
    for (const KeyRow &row : kKeys) {
        if (row.action == Action::Count) continue;
        EXPECT_FALSE(has[(int)row.action]) << row.shown;
        has[(int)row.action] = true;
        EXPECT_EQ(actionOf(row.key, row.shift), row.action) << row.shown;
    }
    for (bool one : has) EXPECT_TRUE(one);
    for (int host : {'W', 'A', 'S', 'D', 'Q', 'E', 'R', 'C', '1', '2', '3', ' '})
        EXPECT_EQ(actionOf(host, false), Action::Count) << (char)host;
}

// The font lacks most other characters and skips them
TEST(Keys, AreListedInLettersThatTheFontHas) {
    for (const KeyRow &row : kKeys)
        for (const char *text : {row.shown, row.what})
            for (const char *c = text; *c; ++c)
                EXPECT_TRUE(std::isalnum(*c) || std::strchr(" .,:-+/", *c)) << text;
}
