// Models as triangles, read from files.
#pragma once

#include "tools/common/command_line.h"
#include "tools/engine/vec3d.h"
#include "tools/picture/picture.h"
#include "tools/radiosity/read/material_changes.h"
#include "tools/radiosity/read/surroundings.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace odraz::radiosity {

// An error in a file: one line that begins with the file's name and, if known, the line number.
struct ModelError : common::Refused {
    using common::Refused::Refused;
};

// A map_Kd or map_Ke: its value is `tint` times the picture at coordinates * `scale` + `offset`.
struct MeshPicture {
    std::string path;                                   // empty: no picture
    std::shared_ptr<const std::string> bytes = nullptr; // an embedded file, whose name is `path`; null: none
    std::array<float, 3> tint = {1, 1, 1};
    std::array<float, 2> scale = {1, 1}, offset = {};
    bool clamp = false; // outside 0 .. 1: true repeats the border, false the picture

    pictures::Picture read() const; // throws Refused
};

struct MeshMaterial {
    std::string name;
    std::array<float, 3> reflects, emits; // Kd, 0 .. 1; Ke, or Ka if that is above 1
    MeshPicture picture = {}, emissionPicture = {};
    bool twoSided = false; // both sides are lit
    bool hasPicture() const { return !(picture.path.empty() && emissionPicture.path.empty()); }
};

struct Triangle {
    std::array<int, 3> corners; // points, counter-clockwise as seen from the lit side
    int material;
};

struct Mesh {
    Vec3 origin = {}; // origin of `points` in the model's coordinates; 0 unless the model is far from 0
    std::vector<Vec3d> points; // all different
    std::vector<Triangle> triangles;
    // Texture coordinates of each triangle's corners, NaN: none; empty if no material has a picture
    std::vector<std::array<float, 6>> coordinates;
    std::vector<MeshMaterial> materials;
    Surroundings lights;          // suns and balls that the model has, in its coordinates
    int flat = 0, duplicates = 0; // numbers of triangles left out: without area; repeated

    double size() const; // the diagonal of its bounding box
    Vec3d middle() const;
};

struct ReadSettings {
    double scale = 1;      // multiplies coordinates
    bool twoSided = false; // both sides are lit
    std::vector<MaterialChange> changes;
};

// Whether a file is a model, by the ending of its name or by its content.
bool isModel(const std::string &path);

// The first line of an OBJ that `export` writes, and how the files of solve and transfer begin.
inline constexpr char kExportedObj[] = "# radiosity by odraz", kSolutionStart[] = "odraz ";
// Claims an output (whole_file.h). Throws Refused if a model is there that `export` did not write.
bool claimOutput(const std::string &path);

// Reads a model and divides its polygons into triangles. Polygons without a material reflect 0.7. The content
// selects the format: glTF 2.0, otherwise Wavefront OBJ. Adds a line to `notes` for everything that was
// repaired or ignored. Throws ModelError, or Refused for changes that do not fit the model.
Mesh readModel(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);

// The triangle's normal, with a length of twice its area.
Vec3d normalOf(const Mesh &mesh, const Triangle &t);

// The least and greatest coordinates of the points; there must be at least one.
std::pair<Vec3d, Vec3d> boxOf(const std::vector<Vec3d> &points);

// Whether any triangle emits light.
bool emitsLight(const Mesh &mesh);

// The area of all triangles.
double areaOf(const Mesh &mesh);

} // namespace odraz::radiosity
