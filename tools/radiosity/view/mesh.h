// A solved model for OpenGL: triangles of its elements, their outlines, and the edges of its polygons.
//
// The geometry is fixed. Light is a separate array with a radiosity for each point, made again when the
// texels change.
#pragma once

#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

struct ViewPoint {
    Vec3 p;
    int16_t n[4];   // the normal, 1 as 32767
    uint32_t patch; // from 1 on, in order of first elements; 0: a polygon's edge
};

struct ViewPatch {
    Vec3 p, n; // the place and normal of its hemicube
};

struct ViewMesh {
    // Throws std::runtime_error if 32 bits are too few for the indices.
    explicit ViewMesh(const Solution &solution);
    std::vector<Rgb> light(const Solution &solution) const; // of each point

    std::vector<ViewPoint> points;
    std::vector<uint32_t> triangles; // counter-clockwise, three of points each
    std::vector<uint32_t> outlines;  // of elements, two of points each
    std::vector<ViewPoint> edges;    // of facets, two each
    std::vector<ViewPatch> patches;
    float size; // the diagonal of its bounding box

private:
    struct CellPoint { // of a point, in the cell that has its light
        int cell;
        float u, v;
    };
    std::vector<CellPoint> cellPoints;
    void placeHemicubes(const Solution &solution, const std::vector<uint32_t> &firsts);
};

} // namespace odraz::radiosity
