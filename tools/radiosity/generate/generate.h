// Example models: the three of the thesis, and three of many small polygons.
#pragma once

#include "tools/radiosity/read/material_changes.h"

#include <string>

namespace odraz::radiosity {

// The OBJ of a model. "cube": a cube lit by one small square in its ceiling; "columns": a hall with columns
// and lamps; "corner": a corridor whose light goes round a corner. If `area` is above 0, polygons are divided
// into triangles of at most that area. Empty for an unknown name. Sets `triangles` to their number.
std::string generateObj(const std::string &kind, double area, size_t *triangles = nullptr);
// The MTL of the materials, after these changes; the OBJ names its file with mtllib. Throws Refused.
std::string generateMtl(const std::vector<MaterialChange> &changes = {});

} // namespace odraz::radiosity
