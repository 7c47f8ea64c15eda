// Facets of charts as polygons in the chart's plane.
#pragma once

#include "radiosity/model.h"

#include <vector>

namespace odraz::radiosity {

// A point on a chart, in world units along its axes.
struct PlanePoint {
    float u, v;
};
using Outline = std::vector<PlanePoint>; // convex, counter-clockwise about the chart's normal

Outline outlineOf(const Facet &facet); // three or four points
double areaOf(const Outline &outline);
// The part of an outline to the left of the line from a to b.
Outline cut(const Outline &outline, PlanePoint a, PlanePoint b);

// The cell at a point of a chart.
int cellAt(const Chart &chart, PlanePoint p);

} // namespace odraz::radiosity
