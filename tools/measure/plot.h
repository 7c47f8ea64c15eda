// Plots as SVG: points with names, those that matter marked.
#pragma once

#include <string>
#include <vector>

struct PlotPoint {
    double x, y;
    std::string name; // shown when the pointer rests on it
    bool shipped;     // marked, with its name beside it
    int series;       // a colour
};

struct Plot {
    std::string title, xName, yName;
    std::vector<std::string> series; // their names
    std::vector<PlotPoint> points;
    bool logarithmicX = false, logarithmicY = false;
    bool lessIsBetterX = true, lessIsBetterY = true; // which corner the front faces
    bool frontOfEach = false;                        // every series has a front of its own
};

// With the front: the points that none beats on both axes, joined. The values must be positive where an axis
// is logarithmic.
std::string svg(const Plot &plot);
