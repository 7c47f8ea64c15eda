// A solved model for OpenGL: the triangles and outlines of its elements, and the edges of its polygons.
//
// The geometry is fixed. Light is a separate array with a radiosity for each point, computed by light().
#pragma once

#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

struct ViewPoint {
    Vec3 p;
    int16_t n[4];   // normal; 32767 stands for 1
    uint32_t patch; // patch number from 1 on, in the order of first elements; 0: a polygon's edge
};

struct ViewPatch {
    Vec3 p, n; // position and normal of its hemicube
};

struct ViewMesh {
    // Throws std::runtime_error if there is no element, or too many for 32-bit indices.
    explicit ViewMesh(const Solution &solution);
    std::vector<Rgb> light(const Solution &solution) const; // the radiosity at each point

    std::vector<ViewPoint> points;
    std::vector<uint32_t> triangles; // counter-clockwise, three indices of points each
    std::vector<uint32_t> outlines;  // lines around elements, two indices of points each
    std::vector<ViewPoint> edges;    // lines around facets, two points each
    std::vector<ViewPatch> patches;
    float size; // diagonal of the bounding box

private:
    std::vector<Solution::CellPoint> cellPoints; // each point's position in the cell that holds its light
};

} // namespace odraz::radiosity
