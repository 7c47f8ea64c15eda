// Tests plots: every point has its mark, and the legend has every name.
#include "tools/picture/plot.h"

#include <regex>

using namespace pictures;

// All matches of the pattern's first group
static std::multiset<std::string> all(const std::string &text, const char *pattern) {
    std::regex what(pattern);
    std::multiset<std::string> found;
    for (std::sregex_iterator m(text.begin(), text.end(), what), end; m != end; ++m) found.insert((*m)[1]);
    return found;
}
constexpr char kMarks[] = "<path class=\"mark\"[^>]* d=\"([^\"]*)\"";

static Plot plotOf(int count, int series) {
    Plot plot = {"title", "x", "y", {}, {}, true, true};
    for (int s = 0; s < series; ++s) plot.series.push_back("series " + std::to_string(s));
    std::mt19937 random(1);
    std::normal_distribution<double> place(0, 1);
    for (int i = 0; i < count; ++i)
        plot.points.push_back({std::exp(place(random)), std::exp(place(random)),
                               "setting " + std::to_string(i), i % 17 == 0, i % series});
    return plot;
}

TEST(Plot, EveryPointIsMarkedAndInTheLegend) {
    for (auto [count, series] : {std::pair{1, 1}, {12, 3}, {120, 6}}) {
        Plot plot = plotOf(count, series);
        std::string drawn = svg(plot);
        std::multiset<std::string> names;
        for (const PlotPoint &p : plot.points) names.insert(p.name);
        EXPECT_EQ(all(drawn, kMarks).size(), plot.points.size());
        EXPECT_EQ(all(drawn, "class=\"name\">([^<]*)<"), names);
        for (const std::string &name : plot.series) EXPECT_NE(drawn.find(">" + name + "<"), drawn.npos);
        // Each number is written twice: next to its mark and in the legend
        for (int i = 1; i <= count; ++i)
            EXPECT_EQ(all(drawn, "font-size=\"10\"[^>]*>([0-9]+)<").count(std::to_string(i)), 2u) << i;
        // All lines of the legend are on the page
        double height = std::stod(*all(drawn, "viewBox=\"0 0 930 ([0-9]+)\"").begin());
        for (const std::string &at : all(drawn, "<text x=\"[-0-9.]+\" y=\"([-0-9.]+)\""))
            EXPECT_LT(std::stod(at), height);
    }
}

TEST(Plot, SeriesDifferByTheirMarks) {
    for (int series : {2, 6, 10}) {
        std::multiset<std::string> marks = all(svg(plotOf(40, series)), kMarks);
        EXPECT_EQ(std::set<std::string>(marks.begin(), marks.end()).size(), (size_t)series);
    }
}

// One of three points is beaten on both axes, so the front skips it.
TEST(Plot, TheFrontJoinsWhatNothingBeats) {
    Plot plot = {
        "title", "x", "y", {"all"}, {{1, 3, "", false, 0}, {2, 4, "", false, 0}, {3, 1, "", false, 0}}};
    EXPECT_EQ(all(svg(plot), "d=\"(M[-0-9. ]+L[-0-9. ]+)\" fill=\"none\"").size(), 1u);
    plot.joined = true;
    EXPECT_EQ(all(svg(plot), "d=\"(M[-0-9. ]+L[-0-9. ]+L[-0-9. ]+)\" fill=\"none\"").size(), 1u);
}
