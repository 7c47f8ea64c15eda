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
    bool lessIsBetterX = true, lessIsBetterY = true; // the corner that the front faces
    bool frontOfEach = false;                        // a front for each series
    bool joined = false; // no fronts; a line joins the points of each series in their order
};

// Draws the plot and its front, a line through the points that no other point beats on both axes. There must
// be at least one point. On a logarithmic axis all values must be positive. A point with a name gets a
// number, which is next to its mark and in the legend.
std::string svg(const Plot &plot);

} // namespace pictures
