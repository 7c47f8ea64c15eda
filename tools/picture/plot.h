// Plots as SVG: points and a legend. Each series has its own mark and colour.
#pragma once

#include <string>
#include <vector>

namespace pictures {

struct PlotPoint {
    double x, y;
    std::string name; // may be empty
    bool shipped;     // has a larger mark, and a bold name in the legend
    int series;       // index of its series
};

struct Plot {
    std::string title, xName, yName;
    std::vector<std::string> series; // their names
    std::vector<PlotPoint> points;
    bool logarithmicX = false, logarithmicY = false;
    bool joined = false; // no fronts; a line joins the points of each series in their order
};

// Draws the plot and a front of each series, a line through its points that none of its others beats on both
// axes, where less is better. There must be at least one point. On a logarithmic axis all values must be
// positive. A point with a name gets a number, which is next to its mark and in the legend.
std::string svg(const Plot &plot);

} // namespace pictures
