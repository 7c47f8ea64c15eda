// The grid that stores light: cells on the charts with texels at their corners (trace/scene/lightmap.h), and
// the sites that send out rays.
//
// A texel has up to four sample points around it, a quarter of a cell's side away, as in radiosity/visible.h.
// Points off the triangles or inside a closed body do not count. A chart of one cell is one site with all its
// points; in larger charts every texel is a site.
#pragma once

#include "tools/radiosity/divide/regions.h"
#include "tools/radiosity/rays/ray_tree.h"

#include "base/parallel.h"

#include <cstdint>
#include <span>
#include <vector>

namespace odraz::radiosity {

// The corners of a mesh's triangles, for RayTree.
std::vector<RayTree::Corners> cornersOf(const Mesh &mesh);
// The corners of the facets' triangles. Sets `chartOf` to the chart of each triangle.
std::vector<RayTree::Corners> cornersOf(std::span<const Facet> facets, const Chart *charts,
                                        std::vector<int> &chartOf);

struct LightGrid {
    static constexpr uint32_t kNone = 0xffffffff;
    struct SamplePoint {
        Vec3 p; // just above the surface
        int texel;
    };
    struct Site {
        uint32_t firstPoint;
        uint16_t pointCount; // 1 ..
        bool small;          // represents its whole chart
        int chart;
        float size; // square root of its area
    };
    const Regions &regions;
    const RayTree tree; // the mesh's triangles
    std::vector<Chart> &charts;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<uint32_t> siteOf; // site of each texel; kNone: the texel is hidden
    std::vector<Site> sites;
    std::vector<SamplePoint> points; // sorted by site, then by texel
    std::vector<int> hidden;         // hidden texels, in the order of filling

    // Divides the charts of a mesh, which the caller keeps, into cells, texels and patches of up to block x
    // block cells. 0: there are no patches; for the viewer, each cell's patch is a site at one of its
    // corners.
    LightGrid(const Mesh &mesh, Regions &regions, Workers &workers, int block = 0);

    Vec3 at(const Texel &t) const;
    // The cell at a point of a chart, and the point's position in it, 0 .. 1.
    struct Spot {
        const Cell *cell;
        float x, y;
    };
    Spot spotAt(int chart, const Vec3 &p) const;
    // Finds the corners' bilinear weights: above 0 for corners with sites, 0 for the others. Returns their
    // sum.
    float weigh(const Spot &spot, float (&weight)[4]) const;
    // Sets each hidden texel's light to the mean of its neighbours that are visible or filled.
    void fill(std::vector<Rgb> &light) const;

private:
    std::vector<uint16_t> ring; // a hidden texel's distance from visible texels, 1 ..; 0: visible
    void divide(int block);
    // Finds the visible sample points. Returns the four points of each texel; only the visible ones are set.
    std::vector<Vec3> findVisible(Workers &workers);
    // Finds the point just above the chart's triangle that is over or under a point of the chart's plane.
    // False if there is none.
    bool surfacePoint(int chart, const Vec3 &p, Vec3 &to) const;
    void makeSites(const std::vector<Vec3> &found);
    void orderHidden();
};

} // namespace odraz::radiosity
