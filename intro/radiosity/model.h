// What radiosity works on: one-sided polygons in planes, divided into patches and cells, the elements.
//
// A chart is a rectangle of a plane with a grid of cells over it; facets are the parts of it that are
// really there, rectangles or triangles (a wall with windows has several), so that light is continuous over
// a whole wall. A patch is a block of cells: it carries a hemicube. Cells carry the light, at their corners,
// the texels. World units as in Scene; any scale. There is room for kMaxCharts charts and kMaxFacets facets,
// which callers must not exceed.
#pragma once

#include "base/arena.h"
#include "base/parallel.h"
#include "trace/scene/scene.h"

namespace odraz {

inline constexpr int kMaxCharts = 1 << 16, kMaxFacets = kMaxShapes, kMaxAcross = 4000;

// Convex, its corners counter-clockwise about the chart's normal, in world units on the chart. A rectangle
// along the chart's axes begins with its lower left corner; a triangle repeats its last one.
struct Facet {
    int chart;
    float u[4], v[4];

    bool triangle() const { return u[3] == u[2] && v[3] == v[2]; }
    Vec3 corner(const Chart &c, int k) const { return c.at(u[k], v[k]); }
};

struct Patch {
    Vec3 p;       // its middle; if part is hidden, the visible place nearest to the middle of those visible
    Vec3 n;       // the normal of its plane
    Rgb reflects; // share of the light that arrives; the solver's caller sets it
    float share;  // the part of its places that is visible, 0 .. 1; 0: it has no hemicube and no light
    float area;   // square world units of what is visible
    int chart;
};

// A corner of cells, where light is kept. It is sampled at four places around it, a quarter of the cells'
// sides away along u (bit 0 of a place's number) and v (bit 1).
struct Texel {
    int chart, x, y; // in cells
    uint8_t visible; // a bit for each place that is on a facet and not inside a solid
    uint8_t ties;    // a hidden one's number of ties to its neighbours
    bool filled;     // hidden, but with light from its neighbours
};

// A cell of a chart. Its corners are at (0, 0), (1, 0), (0, 1) and (1, 1), in this order.
struct Cell {
    int corner[4]; // texels
    int patch, chart;
    float area; // square world units
};

// Moves the light of a texel by `share` towards that of another. Ties are applied one after the other.
struct Tie {
    int texel, towards;
    float share;
};

struct Model {
    int chartCount, facetCount;
    bool open; // backs are visible from where there is light: hemicubes draw them too, which is slower

    // Made by divide()
    Patch *patches;
    Texel *texels;
    Cell *cells;
    Tie *ties; // made by tie()
    int patchCount, texelCount, cellCount, tieCount;

    Chart charts[kMaxCharts];
    Facet facets[kMaxFacets];

    // A rectangle with two sides given as vectors, lit on the side of u x v; returns its chart. kPieces: its
    // facets are added next, by addFacet(); kOpen makes a window of it. Cells have sides of about `cell`, but
    // there are at most kMaxAcross along a side.
    enum Kind { kWhole, kPieces, kOpen };
    int addRect(const Vec3 &corner, const Vec3 &u, const Vec3 &v, int material, float cell,
                Kind kind = kWhole);
    // Adds a facet to the chart that was added last.
    void addFacet(float u0, float v0, float u1, float v1) {
        const float u[4] = {u0, u1, u1, u0}, v[4] = {v0, v0, v1, v1};
        addFacet(u, v);
    }
    void addFacet(const float *u, const float *v);
    // The sides of a box named by kLeft .. kBack, facing out.
    enum Side { kLeft = 1, kRight = 2, kBottom = 4, kTop = 8, kBack = 16, kFront = 32, kUpright = 51 };
    void addBox(const Vec3 &lo, const Vec3 &hi, int material, float cell, unsigned sides);

    // Adds the facets to a scene, whose materials are numbered as the charts' are; windows are left open. All
    // must be rectangles.
    void pose(Scene &scene) const;
    Shape shapeOf(int facet) const;

    // The quarter of a cell at corner k is the place 3 - k of the texel there.
    bool quarterVisible(const Cell &cell, int k) const {
        return texels[cell.corner[k]].visible >> (3 - k) & 1;
    }

    // Divides all charts: patches have `block` x `block` cells where charts are large enough. False when the
    // arena is full.
    bool divide(Arena &arena, int block);
    // Places the hemicubes of patches, and sums up their areas, once it is known what is visible (visible.h).
    void placePatches();
};

} // namespace odraz
