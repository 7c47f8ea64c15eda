// The model for radiosity: one-sided polygons in planes, divided into patches and cells, the elements.
//
// A chart is a rectangle in a plane with a grid of cells. Its facets, rectangles or triangles, are the
// parts of it that exist (a wall with windows has several), so light is continuous over a whole wall. A
// patch is a block of cells and has a hemicube. Light is stored at the corners of cells, the texels. World
// units as in Scene, at any scale. Callers must not exceed kMaxCharts charts and kMaxFacets facets; a scene
// takes kMaxShapes of them.
#pragma once

#include "base/arena.h"
#include "base/parallel.h"
#include "trace/scene/scene.h"

namespace odraz {

inline constexpr int kMaxCharts = 1 << 16, kMaxFacets = 65500, kMaxAcross = 4000;

// A convex polygon, with corners counter-clockwise about the chart's normal, in world units on the chart. A
// rectangle along the chart's axes begins with its lower left corner; a triangle repeats its last corner.
// Only hemicubes take triangles. Posing, visible sample points and direct light are for rectangles.
struct Facet {
    int chart;
    float u[4], v[4];

    bool triangle() const { return u[3] == u[2] && v[3] == v[2]; }
    Vec3 corner(const Chart &c, int k) const { return c.at(u[k], v[k]); }
};

struct Patch {
    Vec3 p; // centre; if part is hidden, the visible sample point nearest to the centroid of all visible ones
    Vec3 n; // normal of its plane
    Rgb reflects; // reflectance; the solver's caller sets it
    float share;  // visible share of its sample points, 0 .. 1; 0: no hemicube and no light
    float area;   // visible area, square world units
    int chart;
};

// A corner of cells, where light is stored. It has four sample points around it, a quarter of the cells'
// sides away along u (bit 0 of a point's index) and v (bit 1).
struct Texel {
    int chart, x, y; // in cells
    uint8_t visible; // a bit for each sample point that is on a facet and not inside a solid
    uint8_t ties;    // if hidden, the number of ties to its neighbours
    bool filled;     // hidden, but gets light from its neighbours
};

// A cell of a chart. Its corners are at (0, 0), (1, 0), (0, 1) and (1, 1), in this order.
struct Cell {
    int corner[4]; // texels
    int patch, chart;
    float area; // square world units
};

// Moves the light of a texel by `share` towards the light of another. Ties are applied in order.
struct Tie {
    int texel, towards;
    float share;
};

struct Model {
    int chartCount, facetCount;
    bool open; // backs are visible from lit places: hemicubes draw them as well, which is slower

    // Set by divide()
    Patch *patches;
    Texel *texels;
    Cell *cells;
    Tie *ties; // set by tie()
    int patchCount, texelCount, cellCount, tieCount;

    Chart charts[kMaxCharts];
    Facet facets[kMaxFacets];

    // Adds a rectangle with sides u and v; its front faces u x v. Returns its chart. kPieces: addFacet() adds
    // facets; kOpen: a window. Cells have sides of about `cell`, at most kMaxAcross of them along each.
    enum Kind { kWhole, kPieces, kOpen };
    int addRect(const Vec3 &corner, const Vec3 &u, const Vec3 &v, int material, float cell,
                Kind kind = kWhole);
    // Adds a facet to the chart that was added last.
    void addFacet(float u0, float v0, float u1, float v1) {
        const float u[4] = {u0, u1, u1, u0}, v[4] = {v0, v0, v1, v1};
        addFacet(u, v);
    }
    void addFacet(const float *u, const float *v);
    // Adds those sides of a box that are set in `sides`, facing out.
    enum Side { kLeft = 1, kRight = 2, kBottom = 4, kTop = 8, kBack = 16, kFront = 32, kUpright = 51 };
    void addBox(const Vec3 &lo, const Vec3 &hi, int material, float cell, unsigned sides);

    // Adds all facets except windows to a scene, with the charts' material indices. They must be rectangles.
    void pose(Scene &scene) const;
    Shape shapeOf(int facet) const;

    // The quarter of a cell at corner k is sample point 3 - k of the texel there.
    bool quarterVisible(const Cell &cell, int k) const {
        return texels[cell.corner[k]].visible >> (3 - k) & 1;
    }

    // Divides charts, large ones into patches of `block` x `block` cells. Returns false if the arena is full.
    bool divide(Arena &arena, int block);
    // Finds the positions of the patches' hemicubes and their visible areas, after findVisible() (visible.h).
    void placePatches();
};

} // namespace odraz
