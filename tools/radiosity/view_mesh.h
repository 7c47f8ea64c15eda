// A solved model as what OpenGL draws: triangles of its elements, their outlines, the edges of its polygons.
//
// Where things lie stays; light is an array beside it, one radiosity a point, made anew when the texels' has
// changed.
#pragma once

#include "tools/radiosity/baked.h"

#include <memory>

namespace odraz {

struct ViewPoint {
    Vec3 p;
    int16_t n[4];   // the normal, 1 as 32767
    uint32_t patch; // from 1 on, in the order of their first elements; 0: an edge
};

struct ViewPatch {
    Vec3 p, n; // where its hemicube stands
};

struct ViewMesh {
    // Throws std::runtime_error where indices of 32 bits are too few.
    explicit ViewMesh(const Baked &baked);
    std::vector<Rgb> light(const Baked &baked) const; // of each point

    std::vector<ViewPoint> points;
    std::vector<uint32_t> triangles; // counter-clockwise, three of points each
    std::vector<uint32_t> outlines;  // of elements, two of points each
    std::vector<ViewPoint> edges;    // of facets, two each
    std::vector<ViewPatch> patches;
    float size; // the diagonal of its box

private:
    struct Place { // of a point, in the cell where its light is
        int cell;
        float u, v;
    };
    std::vector<Place> places;
    void placeHemicubes(const Baked &baked, const std::vector<uint32_t> &firsts);
};

} // namespace odraz
