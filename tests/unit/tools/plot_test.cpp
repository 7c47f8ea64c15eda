// Plots: every point has its name as text, and nothing overlaps.
#include "tools/picture/labels.h"
#include "tools/picture/plot.h"

#include <gtest/gtest.h>
#include <random>
#include <regex>
#include <set>

using namespace pictures;

namespace {

struct Text {
    std::string words;
    Box box;
};
struct Drawn {
    std::vector<Text> names;
    std::vector<Box> marks;
    std::vector<Line> leaders;
    std::set<std::string> shapes; // of marks
};

std::vector<std::smatch> all(const std::string &text, const char *pattern) {
    std::regex what(pattern);
    return {std::sregex_iterator(text.begin(), text.end(), what), std::sregex_iterator()};
}

// Reads from the text of the file what a viewer would draw
Drawn read(const std::string &svg) {
    Drawn d;
    for (auto &m :
         all(svg, "<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"[^>]*class=\"name\" font-size=\"([0-9.]+)\" "
                  "textLength=\"([0-9.]+)\"[^>]*>([^<]*)</text>")) {
        double x = std::stod(m[1]), y = std::stod(m[2]), size = std::stod(m[3]);
        // A letter extends 0.73 of the font size above the line and 0.24 below it
        d.names.push_back({m[5], {x, y - 0.73 * size, x + std::stod(m[4]), y + 0.24 * size}});
    }
    for (auto &m : all(svg, "<path class=\"mark\" transform=\"translate\\(([-0-9.]+) ([-0-9.]+)\\) "
                            "scale\\(([0-9.]+)\\)\" d=\"([^\"]*)\" fill=\"([^\"]*)\"")) {
        double x = std::stod(m[1]), y = std::stod(m[2]), r = std::stod(m[3]);
        d.marks.push_back({x - r, y - r, x + r, y + r});
        d.shapes.insert(m[4].str() + (m[5] == "none" ? " open" : ""));
    }
    for (auto &m : all(svg, "<path class=\"leader\" d=\"M([-0-9.]+) ([-0-9.]+)L([-0-9.]+) ([-0-9.]+)\""))
        d.leaders.push_back({std::stod(m[1]), std::stod(m[2]), std::stod(m[3]), std::stod(m[4])});
    return d;
}

// The number of overlaps
int overprints(const Drawn &d) {
    int count = 0;
    for (size_t i = 0; i < d.names.size(); ++i) {
        for (size_t k = 0; k < i; ++k) count += overlap(d.names[i].box, d.names[k].box);
        for (const Box &mark : d.marks) count += overlap(d.names[i].box, mark);
        for (const Line &leader : d.leaders) {
            Box b = d.names[i].box; // its own leader ends at its edge
            count += crosses(leader, {b.x0 + 1, b.y0 + 1, b.x1 - 1, b.y1 - 1});
        }
    }
    return count;
}

Plot plotOf(int count, int series, double spread) {
    Plot plot = {"title", "x", "y", {}, {}, true, true};
    for (int s = 0; s < series; ++s) plot.series.push_back("way " + std::to_string(s));
    std::mt19937 random(1);
    std::normal_distribution<double> place(0, spread);
    for (int i = 0; i < count; ++i)
        plot.points.push_back({std::exp(place(random)), std::exp(place(random)),
                               "setting " + std::to_string(i), i % 17 == 0, i % series});
    return plot;
}

void expectAllNamed(const Plot &plot) {
    Drawn d = read(svg(plot));
    EXPECT_EQ(d.marks.size(), plot.points.size());
    std::multiset<std::string> names, drawn;
    for (const PlotPoint &p : plot.points) names.insert(p.name);
    for (const Text &t : d.names) drawn.insert(t.words);
    EXPECT_EQ(drawn, names);
    EXPECT_EQ(overprints(d), 0);
}

TEST(Plot, EveryPointIsNamedAndNothingOverprints) {
    for (auto [count, series] : {std::pair{1, 1}, {12, 3}, {120, 6}})
        expectAllNamed(plotOf(count, series, 1));
}

TEST(Plot, ACrowdIsDrawnLarger) {
    Plot plot = plotOf(60, 4, 0.02);
    plot.points.push_back({1e-3, 1e-3, "near nothing", false, 0});
    plot.points.push_back({1e3, 1e3, "far", false, 1});
    expectAllNamed(plot);
}

TEST(Plot, PointsAtOnePlaceAreAllNamed) {
    Plot plot = plotOf(10, 2, 1);
    for (PlotPoint &p : plot.points) p.x = 3, p.y = 4;
    plot.points.push_back({30, 40, "another", true, 0});
    expectAllNamed(plot);
}

TEST(Plot, SeriesDifferByTheirMarks) {
    for (int series : {2, 6, 10}) EXPECT_EQ(read(svg(plotOf(40, series, 1))).shapes.size(), (size_t)series);
}

TEST(Plot, OverlapsAreSeen) {
    Drawn d = {{{"a", {0, 0, 10, 10}}, {"b", {9, 9, 20, 20}}}, {{15, 0, 18, 5}}, {{-5, 5, 25, 5}}, {}};
    EXPECT_EQ(overprints(d), 2); // b covers a; the line crosses a
    EXPECT_FALSE(crosses({0, 0, 10, 0}, {0, 1, 10, 2}));
    EXPECT_TRUE(crosses({0, 0, 10, 10}, {4, 4, 6, 6}));
}

} // namespace
