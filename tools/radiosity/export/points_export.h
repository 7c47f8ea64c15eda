// Exports a solution for spreadsheets, and for viewers of points and polygons. Each function writes one file
// whole or not at all, and throws std::runtime_error.
#pragma once

#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

// CSV: polygon, middle, normal, area and mean radiosity of every element.
void exportCsv(const Solution &solution, const std::string &path);
// PLY or OBJ: polygons with sRGB colours at their points; a comment in the file gives the scale.
void exportPolygons(const Solution &solution, const std::string &path, bool ply);

} // namespace odraz::radiosity
