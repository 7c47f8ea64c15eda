// Tests lists of shown pictures, and their comparison with the film.
#include "tests/support/sanitized.h"
#include "tests/support/thrown.h"
#include "tools/common/command_line.h"
#include "tools/measure/play/viewer.h"

using namespace odraz;
using namespace odraz::measure;

constexpr char kShownHead[] = "at,time,kind,level,width,height,seconds\n";

// The list of a player that is never late: `rate` pictures a second from one moment to another, each shown
// from its own time until the next one. One picture in `every` is traced, the others are in-betweens.
static std::vector<ShownPicture> steady(double from, double to, double rate, int every, float level,
                                        int width, int height) {
    std::vector<ShownPicture> list;
    // Count from the film's start, so that the same pictures are traced whatever `from` is
    long first = std::max(0l, (long)std::floor(from * rate)), last = (long)std::ceil(to * rate);
    first -= first % every, last += (every - last % every) % every;
    for (long n = first; n <= last; ++n)
        list.push_back({(double)n / rate, (double)n / rate, n % every != 0, level, width, height});
    return list;
}

static std::string wrongIn(const std::string &rows) {
    return thrown<common::Refused>([&] { parseShown(kShownHead + rows); });
}

TEST(Shown, ListsAreWrittenAndRead) {
    std::vector<ShownPicture> list = steady(3, 4, 30, 4, 1.25f, 640, 360);
    list[4].at = -1; // it was never shown
    EXPECT_EQ(printShown(parseShown(printShown(list))), printShown(list));
    EXPECT_TRUE(parseShown(kShownHead).empty());
}

TEST(Shown, WhatIsWrongIsReported) {
    EXPECT_THROW(parseShown(""), common::Refused);
    EXPECT_THROW(parseShown("at,time\n"), common::Refused);
    EXPECT_EQ(wrongIn("1,1,traced,1,64,36,0.01\n1,1\n").substr(0, 7), "line 3:");
    for (const char *row :
         {"1,1,made,1,64,36,0.01", "1,1,traced,3,64,36,0.01", "1,1,traced,nan,64,36,0.01",
          "1,1,traced,1,0,36,0.01", "1,1,traced,1,64,36,0.01,7", "nan,1,traced,1,64,36,0.01",
          "1,-1,traced,1,64,36,0.01", "1,1,between,1,64,36,0.01", "1,1,traced,1,64,36",
          "1,1,traced,1,64,36,-1", "1,1,traced,1,64,36,nan"})
        EXPECT_NE(wrongIn(std::string(row) + "\n"), "") << row;
    const std::string first = "1,1,traced,1,64,36,0.01\n", second = "2,2,between,1,64,36,0.01\n",
                      third = "2.5,2.5,between,1,64,36,0.01\n", last = "3,3,traced,1,64,36,0.01\n";
    EXPECT_EQ(wrongIn(first + second + last), "");
    EXPECT_EQ(wrongIn(first + second + third + last), "");
    EXPECT_NE(wrongIn(first + second), "");
    EXPECT_NE(wrongIn(first + "2,2,between,1,32,36,0.01\n" + third + last), "");
    EXPECT_NE(wrongIn(first + second + "3,3,traced,1,32,36,0.01\n"), "");
    EXPECT_NE(wrongIn("2,1,traced,1,64,36,0.01\n1,2,traced,1,64,36,0.01\n"), "");
    EXPECT_NE(wrongIn("2,2,traced,1,64,36,0.01\n" + first), "");
}

TEST(Shown, TheLatestOneIsOnScreen) {
    std::vector<ShownPicture> list = {
        {1, 1, false, 1, 64, 36}, {-1, 2, false, 1, 64, 36}, {3, 3, false, 1, 64, 36}};
    EXPECT_EQ(onScreenAt(list, 0.9), -1);
    EXPECT_EQ(onScreenAt(list, 1), 0);
    EXPECT_EQ(onScreenAt(list, 2.5), 0); // the second was never shown
    EXPECT_EQ(onScreenAt(list, 9), 2);
}

// Each in-between is made from the nearest traced pictures on both sides.
TEST(Shown, InBetweensHaveTheirGap) {
    std::vector<ShownPicture> list = steady(10, 10.2, 60, 4, 2, 64, 36);
    for (size_t i = 0; i < list.size(); ++i) {
        MadeFrom from = madeFrom(list, i);
        EXPECT_NEAR(from.gap(), list[i].between ? 4 : 0, 1e-6) << i;
        EXPECT_EQ(&from.earlier, &list[i - i % 4]);
        EXPECT_EQ(&from.later, &list[(i + 3) / 4 * 4]);
    }
    // With one traced picture missing, the gap is wider
    list = {{1, 1, false, 1, 64, 36}, {1.05, 1.05, true, 1, 64, 36}, {1.15, 1.15, false, 1, 64, 36}};
    EXPECT_NEAR(madeFrom(list, 1).gap(), 9, 1e-6);
}

static SeenErrors seenOf(Viewer &viewer, const std::vector<ShownPicture> &list, double from, double to) {
    SeenErrors seen;
    viewer.compare(list, from, to, seen);
    return seen;
}

// The moment is in the flake's flight, where everything moves.
FIGURES_TEST(Viewer, RanksRatesGapsAndSizes) {
    constexpr double kFrom = 49.5, kTo = 49.75; // FLIP is of its third, eighth and 13th sixtieth
    Viewer viewer(320, 180, kFrom, kTo);
    auto seen = [&](double rate, int every, float level, int width) {
        return seenOf(viewer, steady(kFrom, kTo, rate, every, level, width, width * 9 / 16), kFrom, kTo);
    };
    SeenErrors film = seen(60, 1, 0, 320);
    EXPECT_EQ(film.sixtieths, 15);
    EXPECT_EQ(film.flips, 3);
    EXPECT_EQ(film.fresh, 14);
    EXPECT_EQ(film.flip, 0);
    EXPECT_EQ(film.srgbPsnr(), kMostPsnr);
    SeenErrors play = seen(60, 1, 1, 320), half = seen(30, 1, 1, 320), quarter = seen(15, 1, 1, 320),
               pairs = seen(60, 2, 1, 320), fours = seen(60, 4, 1, 320), thirty = seen(30, 2, 1, 320),
               small = seen(60, 1, 1, 160);
    EXPECT_EQ(half.fresh, 7);
    EXPECT_GT(play.srgbPsnr(), pairs.srgbPsnr());
    EXPECT_GT(pairs.srgbPsnr(), half.srgbPsnr() + 1);
    EXPECT_GT(pairs.srgbPsnr(), fours.srgbPsnr());
    EXPECT_GT(fours.srgbPsnr(), thirty.srgbPsnr() + 1);
    EXPECT_GT(half.srgbPsnr(), thirty.srgbPsnr());
    EXPECT_GT(half.srgbPsnr(), quarter.srgbPsnr() + 1);
    EXPECT_GT(play.srgbPsnr(), small.srgbPsnr() + 1);
    EXPECT_LT(play.meanFlip(), pairs.meanFlip());
    EXPECT_LT(pairs.meanFlip(), half.meanFlip());
    EXPECT_LT(half.meanFlip(), quarter.meanFlip());
}

TEST(Viewer, RefusesWhatCannotBeShown) {
    constexpr double kFrom = 52.5, kTo = 52.6;
    Viewer viewer(320, 180, kFrom, kTo);
    for (const std::vector<ShownPicture> &wrong :
         {steady(kFrom, kTo, 60, 1, 1, 640, 360),         // larger than the screen
          steady(kFrom + 0.05, kTo, 60, 1, 1, 320, 180)}) // a late start
        EXPECT_THROW(seenOf(viewer, wrong, kFrom, kTo), common::Refused);
}

// Errors do not depend on earlier comparisons, though the viewer keeps pictures.
TEST(Viewer, ErrorsDoNotDependOnKeptPictures) {
    constexpr double kFrom = 30, kTo = 30.2;
    auto seenBy = [&](Viewer &viewer, std::vector<std::vector<uint8_t>> &all) {
        SeenErrors seen;
        viewer.compare(steady(kFrom, kTo, 60, 4, 1, 160, 90), kFrom, kTo, seen,
                       [&](const auto &shown, const auto &truth) {
                           all.push_back(shown);
                           all.push_back(truth);
                       });
        return seen;
    };
    std::vector<std::vector<uint8_t>> first, again;
    Viewer viewer(160, 90, kFrom, kTo);
    SeenErrors a = seenBy(viewer, first);
    seenOf(viewer, steady(kFrom, kTo, 60, 6, 1.5f, 128, 72), kFrom, kTo);
    SeenErrors b = seenBy(viewer, again);
    EXPECT_EQ(first.size(), 24u);
    EXPECT_TRUE(first == again);
    EXPECT_EQ(a.srgb, b.srgb);
    EXPECT_EQ(a.flip, b.flip);
}
