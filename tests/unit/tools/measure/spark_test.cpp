// Tests that the spark detector finds the sparks planted into clean pictures, and no others.
#include "tools/measure/inspection/spark.h"

#include "tests/support/dice.h"

#include <cstdlib>

using namespace odraz;
using namespace odraz::measure;

struct ThreePictures {
    Grey before, now, after;
};

// Bars, discs and a checker over a slope, with noise, moving by a pixel per picture.
static ThreePictures drawn(uint32_t seed) {
    auto at = [&](int shift) {
        Grey g = {200, 120, std::vector<uint8_t>(200 * 120)};
        Dice dice(seed + (uint32_t)shift * 100003u);
        for (int y = 0; y < g.height; ++y)
            for (int x = 0; x < g.width; ++x) {
                int i = x + shift, level = 20 + i / 3;
                if (i % 50 < 4) level += 60;
                if ((i - 100) * (i - 100) + (y - 60) * (y - 60) < 900) level += 70;
                if (y > 90 && ((i / 6 + y / 6) & 1)) level += 30;
                g.level[(size_t)(y * g.width + x)] = (uint8_t)(level + (int)(dice(0, 1) * 3));
            }
        return g;
    };
    return {at(0), at(1), at(2)};
}

struct Tally {
    int planted = 0, found = 0, others = 0;
};

// Plants sparks of one to three adjacent pixels, 40 to 200 levels above their surroundings, one in every
// field of 20 x 20 pixels.
static void plant(const ThreePictures &clean, Dice &dice, Tally &tally) {
    Grey now = clean.now;
    std::vector<Spark> planted;
    for (int top = 0; top + 20 <= now.height; top += 20)
        for (int left = 0; left + 20 <= now.width; left += 20) {
            int x = left + 4 + (int)(dice(0, 1) * 12), y = top + 4 + (int)(dice(0, 1) * 12), around = 0;
            for (int j = -4; j <= 4; ++j)
                for (int i = -4; i <= 4; ++i) around = std::max(around, now.at(x + i, y + j));
            int level = std::min(around + 40 + (int)(dice(0, 1) * 160), 255);
            if (level < around + 40) continue; // too bright here for a spark
            for (int i = 0, size = 1 + (int)(dice(0, 1) * 3), px = x, py = y; i < size; ++i) {
                now.level[(size_t)(py * now.width + px)] = (uint8_t)level;
                (dice(0, 1) < 0.5f ? px : py) += 1;
            }
            planted.push_back({x, y, 0, 0});
        }
    auto near = [](const Spark &a, const Spark &b) {
        return std::abs(a.x - b.x) < 4 && std::abs(a.y - b.y) < 4;
    };
    std::vector<Spark> sparks = sparksOf(pointsOf(now, 24), now, &clean.before, &clean.after, 3);
    tally.planted += (int)planted.size();
    for (const Spark &p : planted)
        tally.found += std::any_of(sparks.begin(), sparks.end(), [&](auto &s) { return near(s, p); });
    for (const Spark &s : sparks)
        tally.others += std::none_of(planted.begin(), planted.end(), [&](auto &p) { return near(s, p); });
}

TEST(Sparks, PlantedInDrawingsAreFoundAndNothingElse) {
    Dice dice(7);
    Tally tally;
    for (uint32_t i = 0; i < 20; ++i) plant(drawn(i), dice, tally);
    ASSERT_GT(tally.planted, 500);
    EXPECT_GE(tally.found, tally.planted * 0.95);
    EXPECT_EQ(tally.others, 0);
}

TEST(Sparks, AreNotPointsThatStayOrMove) {
    ThreePictures clean = drawn(1);
    auto dot = [](Grey &g, int x, int y) { g.level[(size_t)(y * g.width + x)] = 255; };
    dot(clean.before, 20, 20), dot(clean.now, 22, 21), dot(clean.after, 24, 22);
    EXPECT_EQ(pointsOf(clean.now, 24).size(), 1u);
    EXPECT_TRUE(sparksOf(pointsOf(clean.now, 24), clean.now, &clean.before, &clean.after, 3).empty());
    EXPECT_EQ(sparksOf(pointsOf(clean.now, 24), clean.now, &clean.before, &clean.after, 1).size(), 1u);
}

TEST(Sparks, AreNotSoughtAcrossACut) {
    ThreePictures clean = drawn(1);
    clean.now.level[50 * 200 + 20] = 255;
    Grey other = {200, 120, std::vector<uint8_t>(200 * 120, 200)};
    std::vector<Spark> points = pointsOf(clean.now, 24);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_TRUE(sparksOf(points, clean.now, &other, nullptr, 3).empty());
    EXPECT_EQ(sparksOf(points, clean.now, &other, &clean.after, 3).size(), 1u);
}
