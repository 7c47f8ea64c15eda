// Makes a mesh of a model's polygons: merges points, divides polygons into triangles, and leaves out those
// without area and those given twice.
#pragma once

#include "tools/radiosity/read/mesh.h"

#include <map>
#include <set>

namespace odraz::radiosity {

// What the reader of a format finds.
struct Polygons {
    struct Corner {
        int point, coordinate; // the latter -1: none
    };
    struct Polygon {
        size_t firstCorner; // the last one ends where the next polygon's begin
        int material;       // -1: none
        int line;           // of the file, or the number of this polygon
    };
    std::vector<Vec3d> points;
    std::vector<std::array<float, 2>> coordinates; // on pictures
    std::vector<Corner> corners;
    const char *unit = "line"; // what Polygon::line counts
    std::vector<Polygon> polygons;
};

inline constexpr char kNoMaterial[] = "(none)"; // the name of the material of polygons without one
MeshMaterial noMaterial();

// Sets what a material reflects and emits, by the names in its file. More than 1 is reflected as 1, with a
// note. Throws ModelError if a value is below 0, or above kMostPower.
void setColours(MeshMaterial &material, const std::array<double, 3> &reflects,
                const std::array<double, 3> &emits, const std::array<const char *, 2> &names,
                const std::string &path, std::vector<std::string> &notes);

// Kinds of things that are not used, each with what has them. A kind becomes one note.
using NotedKinds = std::map<std::string, std::vector<std::string>>;
void noteKinds(const std::string &path, const NotedKinds &kinds, std::vector<std::string> &notes);

// The mesh of these polygons and materials, with a note for each kind of thing that is left out or doubtful.
// Notes and errors begin with `path`. Throws ModelError if nothing is left, or if the model is too large or
// too small.
Mesh buildMesh(const std::string &path, Polygons polygons, std::vector<MeshMaterial> materials,
               const ReadSettings &settings, std::vector<std::string> &notes);

// Finds each name's material: its index in `materials`, or -1.
std::vector<int> findMaterials(const std::vector<std::string> &names,
                               const std::vector<MeshMaterial> &materials);
// Adds notes about used materials that are black. If all are, they become grey, because nothing would be
// visible.
void noteBlack(std::vector<MeshMaterial> &materials, const std::vector<bool> &used, const std::string &path,
               std::vector<std::string> &notes);

// Pictures of emission (map_Ke): divides triangles whose material has MeshMaterial::glow until each part
// emits evenly, about as the picture shows it. Parts that emit alike share a material, which has the name of
// the whole. Adds a note for a picture that cannot be read; its materials emit Ke.
void divideByEmission(Mesh &mesh, std::vector<std::string> &notes);

// Faces that overlap in one plane and face the same way. Which of them a ray hits would depend on rounding,
// so the first one in the file is in front: what it covers is cut out of the others.
using PolygonPair = std::pair<int, int>; // the one in front, the one behind

// Cuts a mesh, and returns the polygons that overlapped. `polygonOf` has the polygon of each triangle.
// Triangles that share one do not overlap unless its number is negative. Afterwards it fits the new
// triangles. Distances below `tiny` count as zero. The time for N triangles, P pairs of which overlap, is
// about N log N + P.
std::set<PolygonPair> cutOverlaps(Mesh &mesh, std::vector<int> &polygonOf, double tiny);

// The readers of the formats, as readModel() in mesh.h describes: glTF 2.0 (.gltf and .glb), and Wavefront
// OBJ with its materials.
Mesh readGltf(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);
Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);

} // namespace odraz::radiosity
