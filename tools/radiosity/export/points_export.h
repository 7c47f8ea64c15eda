// Exports a solution for spreadsheets, and for viewers of points and polygons. Each export writes a whole
// file or none, and throws std::runtime_error.
#pragma once

#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

// The light (or radiosity) that 1 stands for in a picture: the 99th percentile of the texels (of surfaces
// that do not emit) divided by 0.9.
float lightOfOne(const Solution &solution, bool radiosity);

// A field of CSV, in quotes where it needs them (RFC 4180).
std::string csvField(const std::string &text);

// CSV: polygon, middle, normal, area, mean radiosity and material of each element.
void exportCsv(const Solution &solution, const std::string &path);
// PLY or OBJ: polygons with sRGB colours at their points. A comment in the file states the scale.
void exportPolygons(const Solution &solution, const std::string &path, bool ply);

} // namespace odraz::radiosity
