// Makes a mesh of a model's polygons: merges points, divides polygons into triangles, and leaves out those
// without area and those given twice.
#pragma once

#include "tools/radiosity/read/mesh.h"

namespace odraz::radiosity {

// What the reader of a format finds.
struct Polygons {
    struct Corner {
        int point, coordinate; // the latter -1: none
    };
    struct Polygon {
        size_t firstCorner; // the last one ends where the next polygon's begin
        int material;       // -1: none
        int line;           // of the file
    };
    std::vector<Vec3d> points;
    std::vector<std::array<float, 2>> coordinates; // on pictures
    std::vector<Corner> corners;
    std::vector<Polygon> polygons;
};

inline constexpr char kNoMaterial[] = "(none)"; // the name of the material of polygons without one
MeshMaterial noMaterial();

// The mesh of these polygons and materials, with a note for each kind of thing that is left out or doubtful.
// Notes and errors begin with `path`. Throws ModelError if nothing is left, or if the model is too large or
// too small.
Mesh buildMesh(const std::string &path, Polygons polygons, std::vector<MeshMaterial> materials,
               const ReadSettings &settings, std::vector<std::string> &notes);

// Adds notes about used materials that are black. If all are, they become grey, because nothing would be
// visible.
void noteBlack(std::vector<MeshMaterial> &materials, const std::vector<bool> &used, const std::string &path,
               std::vector<std::string> &notes);

} // namespace odraz::radiosity
