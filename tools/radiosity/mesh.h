// Models as triangles, read from Wavefront OBJ.
#pragma once

#include "tools/common/arguments.h"
#include "tools/common/vec3d.h"

#include <array>
#include <string>
#include <vector>

// What is wrong with a file, in one line that begins with its name and, where it is known, the line in it.
struct ModelError : odraz::Refused {
    using Refused::Refused;
};

// map_Kd: it reflects tint times what the picture has at coordinates times scale plus offset.
struct MeshPicture {
    std::string path; // empty: there is none
    std::array<float, 3> tint = {1, 1, 1};
    std::array<float, 2> scale = {1, 1}, offset = {};
    bool clamp = false; // outside of 0 .. 1 its border goes on, not the picture
};

struct MeshMaterial {
    std::string name;
    std::array<float, 3> reflects, emits; // Kd, 0 .. 1; Ke, or Ka where that is above 1, 0 ..
    MeshPicture picture = {};
};

struct Triangle {
    std::array<int, 3> corners; // points, counter-clockwise about the side that is lit
    int material;
};

struct Mesh {
    std::vector<odraz::Vec3d> points; // no two alike
    std::vector<Triangle> triangles;
    // Texture coordinates of each triangle's corners, NaN where it has none; empty where no material has a
    // picture
    std::vector<std::array<float, 6>> coordinates;
    std::vector<MeshMaterial> materials;
    int flat = 0, twice = 0; // triangles that were left out: without area; given before

    double size() const; // the diagonal of its box
    odraz::Vec3d middle() const;
};

struct ReadSettings {
    double scale = 1;      // of coordinates
    bool twoSided = false; // backs are lit, too
};

// Polygons of any count are divided into triangles; those without material reflect 0.7. Throws ModelError.
// What was repaired or ignored is told in `notes`, a line each.
Mesh readObj(const std::string &path, const ReadSettings &settings, std::vector<std::string> &notes);

// Twice the area of a triangle, as a vector along its normal.
odraz::Vec3d normalOf(const Mesh &mesh, const Triangle &t);

// Whether some triangle emits light.
bool shines(const Mesh &mesh);

// Of all triangles.
double areaOf(const Mesh &mesh);
