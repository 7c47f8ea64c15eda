// Example models: the thesis's three, three of many small polygons, and two whose light is known.
#pragma once

#include "tools/radiosity/read/material_changes.h"

#include <string>

namespace odraz::radiosity {

// The OBJ of a model; empty for an unknown `kind`. "cube": a cube lit by one small square in its ceiling;
// "columns": a hall with columns and lamps; "corner": a corridor whose light goes round a corner; "cave": an
// uneven sphere seen from inside; "vault", "terrain": see obj_writer.h; "furnace", "squares": see README.md.
// If `area` is above 0, polygons are divided into triangles of at most that area. `triangles` receives their
// number.
std::string generateObj(const std::string &kind, double area, size_t *triangles = nullptr);
// The MTL of the materials after these changes. The OBJ needs an mtllib with its file. Throws Refused.
std::string generateMtl(const std::vector<MaterialChange> &changes = {});

} // namespace odraz::radiosity
