// Plots as SVG: points and a legend. Each series has its own mark and colour.
#pragma once

#include <string>
#include <vector>

namespace pictures {

struct PlotPoint {
    double x, y;
    std::string name; // may be empty
    bool shipped;     // its mark is larger, its name bold in the legend
    int series;       // the number of its series
};

struct Plot {
    std::string title, xName, yName;
    std::vector<std::string> series; // their names
    std::vector<PlotPoint> points;
    bool logarithmicX = false, logarithmicY = false;
    bool lessIsBetterX = true, lessIsBetterY = true; // which corner the front faces
    bool frontOfEach = false;                        // one front for each series
    bool joined = false; // instead of fronts: the points of each series are joined in their order
};

// The plot with its front: the points that no other point beats on both axes, joined. There must be a point.
// On a logarithmic axis all values must be positive. A point with a name has a number beside its mark, by
// which the legend names it.
std::string svg(const Plot &plot);

} // namespace pictures
