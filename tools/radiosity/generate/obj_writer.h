// Writes a generated model as Wavefront OBJ, polygon by polygon.
#pragma once

#include "tools/common/text.h"
#include "tools/support/vec3d.h"

#include <map>
#include <string>

namespace odraz::radiosity {

// Builds the text of an OBJ, in which each point is listed once.
struct ObjWriter {
    double area = 0; // largest area of a triangle; 0: polygons stay undivided
    size_t triangles = 0;
    std::string points, faces;
    std::map<Vec3d, int> numbers;
    const char *material = "";

    // The number of a point from 1 on. Adds the point if it is new.
    int number(Vec3d p) {
        for (size_t k = 0; k < 3; ++k) p[k] = std::round(p[k] * 1e6) / 1e6 + 0.0;
        auto [entry, added] = numbers.try_emplace(p, (int)numbers.size() + 1);
        if (added) common::append(points, "v %.9g %.9g %.9g\n", p[0], p[1], p[2]);
        return entry->second;
    }
    // Selects a material.
    void use(const char *mtl) {
        if (mtl != material) faces += "usemtl " + std::string(mtl) + "\n";
        material = mtl;
    }
    void triangle(const char *mtl, int a, int b, int c) {
        use(mtl);
        common::append(faces, "f %d %d %d\n", a, b, c);
        ++triangles;
    }
    // The surface f(u, v) for u and v in 0 .. 1, lit on the side of df/du x df/dv. It is divided into
    // columns x rows squares of two triangles each. `around`: its sides u = 0 and u = 1 coincide.
    template <class F> void surface(const char *mtl, int columns, int rows, bool around, F &&f) {
        auto at = [&](int i, int j) {
            return number(f((double)(around ? i % columns : i) / columns, (double)j / rows));
        };
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) {
                int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
                if (a != b && b != c && a != c) triangle(mtl, a, b, c);
                if (a != c && c != d && a != d) triangle(mtl, a, c, d);
            }
    }
};

// A nave under a barrel vault, without lamps: two rows of columns, arched windows to the sky, cloths, and on
// the floor vases, balls and rings. It has 30,000 triangles, or the number that ObjWriter::area requires.
void makeVault(ObjWriter &w);

// A closed room with a lamp, a hilly floor, and boulders.
void makeTerrain(ObjWriter &w);

} // namespace odraz::radiosity
