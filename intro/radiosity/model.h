// What radiosity works on: rooms of one-sided rectangles, divided into patches and elements.
//
// A chart is a rectangle of a plane with a grid of elements over it; facets are the parts of it that are
// really there (a wall with windows has several), so that light is continuous over a whole wall. A patch is a
// block of elements: it carries a hemicube, the elements carry the light. Each element is looked at in four
// places; those that lie in no facet or inside a solid are hidden. Elements without any other get their
// neighbours' light, for interpolation's sake. World units as in Scene; any scale. Up to kMaxCharts charts
// and kMaxFacets facets; what is too much is dropped.
#pragma once

#include "base/arena.h"
#include "base/parallel.h"
#include "trace/scene.h"

namespace odraz {

inline constexpr int kMaxCharts = 400, kMaxFacets = 500;

struct Facet {
    int chart;
    float u0, v0, u1, v1; // world units on the chart
};

// A block of elements of one chart.
struct Patch {
    Vec3 p;      // its middle; where some of it is hidden, the visible place nearest to the middle of those
    float share; // of its places that are visible, 0 .. 1; 0: it has no hemicube and no light
    uint16_t chart;
    int16_t i, j; // its first element
};

// The four places of an element, as shares of its sides.
inline float placeU(int place) { return place & 1 ? 0.75f : 0.25f; }
inline float placeV(int place) { return place & 2 ? 0.75f : 0.25f; }

struct Model {
    Chart charts[kMaxCharts];
    Facet facets[kMaxFacets];
    int chartCount, facetCount;
    bool solid; // no back is to be seen from where there is light: hemicubes leave backs out, which is faster

    // Made by divide()
    Patch *patches;
    uint8_t *visible; // of every texel: a bit for each place of an element that can be seen
    int patchCount, texelCount;

    // A rectangle with two sides given as vectors, lit on the side of u x v; returns its chart. Without
    // facet: to be given some by addFacet(). Elements have sides of about `element`; kOpen makes a window of
    // it.
    enum Kind { kWhole, kPieces, kOpen };
    int addRect(Vec3 corner, Vec3 u, Vec3 v, int material, float element, Kind kind = kWhole);
    void addFacet(int chart, float u0, float v0, float u1, float v1);
    // The sides of a box named by kLeft .. kBack, facing out.
    enum Side { kLeft = 1, kRight = 2, kBottom = 4, kTop = 8, kBack = 16, kFront = 32, kUpright = 51 };
    void addBox(Vec3 lo, Vec3 hi, int material, float element, unsigned sides);

    // Divides all charts: patches have `block` x `block` elements where charts are large enough. Finds what
    // is hidden. False when the arena is full.
    bool divide(Arena &arena, Workers &workers, int block);

    // Adds the facets to a scene, whose materials are numbered as the charts' are; windows are left open.
    void pose(Scene &scene) const;
};

} // namespace odraz
