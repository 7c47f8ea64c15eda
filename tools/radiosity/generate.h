// The thesis's three kinds of model.
#pragma once

#include <string>

// "cube": a cube lit by one small square in its ceiling; "columns": a hall with columns and lamps; "corner":
// a corridor whose light goes round a corner. With an area the polygons are divided into triangles of no more
// than that. Empty for any other name. `triangles` gets how many there are.
std::string generateObj(const std::string &kind, double area, size_t *triangles = nullptr);
// Their materials, for a file beside it that the OBJ names with mtllib.
std::string generateMtl();
