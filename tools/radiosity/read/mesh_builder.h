// Builds a mesh from polygons: merges points, divides polygons into triangles, and drops triangles that are
// repeated or have no area.
#pragma once

#include "tools/radiosity/read/mesh.h"

#include <map>
#include <set>

namespace odraz::radiosity {

// A file's polygons, as the reader of its format finds them.
struct Polygons {
    struct Corner {
        int point, coordinate; // indices; coordinate -1: none
    };
    struct Polygon {
        size_t firstCorner; // its corners end where the next polygon's begin
        int material;       // -1: none
        int line;           // line in the file, or number of the polygon; see `unit`
        int object = -1;    // -1: none
    };
    std::vector<Vec3d> points;
    std::vector<std::array<float, 2>> coordinates; // on the material's pictures
    std::vector<Corner> corners;
    const char *unit = "line"; // what Polygon::line counts
    std::vector<Polygon> polygons;
    std::vector<MeshObject> objects;
};

// Sets a material's reflectance and emission. `names`: what its file calls the two. Reflectance above 1
// becomes 1, with a note. Throws ModelError if a value is below 0 or above kMostPower.
void setColours(MeshMaterial &material, const std::array<double, 3> &reflects,
                const std::array<double, 3> &emits, const std::array<const char *, 2> &names,
                const std::string &path, std::vector<std::string> &notes);

// Features that are not used, each with the names of the objects that have it. A feature becomes one note.
using NotedKinds = std::map<std::string, std::vector<std::string>>;
void noteKinds(const std::string &path, const NotedKinds &kinds, std::vector<std::string> &notes);

// Builds the mesh. Adds a note for each kind of polygon that is left out or doubtful. Notes and errors begin
// with `path`. Throws ModelError if nothing is left, or for a model that is too large or too small.
Mesh buildMesh(const std::string &path, Polygons polygons, std::vector<MeshMaterial> materials,
               const ReadSettings &settings, std::vector<std::string> &notes);

// Divides triangles whose material has an emissionPicture until each part has about one colour. Equal
// colours share a material, with the original's name. Adds a note for a picture that cannot be read; its
// materials emit Ke.
void divideByEmission(Mesh &mesh, std::vector<std::string> &notes);

using PolygonPair = std::pair<int, int>; // the one in front, the one behind

// Cuts polygons that overlap in one plane and face the same way. Which of them a ray hits would depend on
// rounding, so the first one in the file is in front: the others lose the part that it covers. Returns the
// pairs that overlapped. `polygonOf` has the polygon of each triangle, and is changed with the triangles;
// triangles of one polygon are not compared unless its number is negative. Distances below `tiny` count as
// zero. The time for N triangles, P pairs of which overlap, is about N log N + P.
std::set<PolygonPair> cutOverlaps(Mesh &mesh, std::vector<int> &polygonOf, double tiny);

// Read glTF 2.0 (.gltf, .glb) or Wavefront OBJ with its materials, as readModel() in mesh.h.
Mesh readGltf(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);
Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);
// Whether the first line that is not empty is a comment or a command of OBJ.
bool isObj(std::string_view start);

} // namespace odraz::radiosity
