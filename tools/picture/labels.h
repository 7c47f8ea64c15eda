// Places names beside the points of a plot so that nothing overlaps.
//
// Lengths are those of the drawing; y points down. It tries places around each point, nearer ones first; a
// name that lies apart from its point gets a line to it. The method is greedy and starts with points in
// crowds: good enough for hundreds.
#pragma once

#include <string>
#include <vector>

namespace pictures {

struct Box {
    double x0, y0, x1, y1;
};
bool overlap(const Box &a, const Box &b);

struct Line {
    double x0, y0, x1, y1;
};
bool crosses(const Line &line, const Box &box);

struct NamedPoint {
    double x, y, radius; // of its mark
    double width;        // of its name
    bool first;          // placed before all others
};

struct Label {
    Box box;
    bool led; // a line leads to it
    Line leader;
};

// A label for each point, inside a box. No label overlaps another label or a mark, and no leader crosses
// either. A label or leader crosses the lines to avoid only where the way round is long. Empty if there is no
// room.
std::vector<Label> placeLabels(const std::vector<NamedPoint> &points, const std::vector<Line> &avoid,
                               const Box &within, double height);

} // namespace pictures
