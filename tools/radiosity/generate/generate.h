// Example models: the three of the thesis, and three of many small polygons.
#pragma once

#include "tools/radiosity/read/material_changes.h"

#include <string>

namespace odraz::radiosity {

// The OBJ of a model. "cube": a cube lit by one small square in its ceiling; "columns": a hall with columns
// and lamps; "corner": a corridor whose light goes round a corner. If `area` is given, polygons are divided
// into triangles no larger than that. Empty for any other name. `triangles` gets their number.
std::string generateObj(const std::string &kind, double area, size_t *triangles = nullptr);
// The materials, with changes, for a file beside the OBJ, which names it with mtllib. Throws Refused.
std::string generateMtl(const std::vector<MaterialChange> &changes = {});

} // namespace odraz::radiosity
