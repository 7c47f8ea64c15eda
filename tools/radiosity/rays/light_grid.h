// The grid on which light is kept: cells over the charts with texels at their corners
// (trace/scene/lightmap.h), and the sites that send out rays.
//
// A texel has up to four places around it, a quarter of a cell's side away, as in radiosity/visible.h. Places
// off the triangles or inside a closed body do not count. A chart of one cell is one site with all its
// places; in larger charts every texel is a site.
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
// Those of facets. Sets `chartOf` to the chart of each triangle.
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
    std::vector<Chart> &charts;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<uint32_t> siteOf; // of each texel; kNone: it is hidden
    std::vector<Site> sites;
    std::vector<SamplePoint> points; // of each site, and of each texel, in order
    std::vector<int> tied;           // hidden texels, in the order of filling

    // Numbers the cells, texels and patches of the charts, which the caller keeps. A patch has `block` by
    // `block` cells where charts are large enough.
    LightGrid(Regions &regions, const RayTree &tree, Workers &workers, int block = 1);
    // For the viewer, without patches: makes the patch of a cell the site that sends out its rays.
    void useSitesAsPatches();

    Vec3 at(const Texel &t) const;
    // The cell at a point of a chart, and the position in it, 0 .. 1.
    struct Spot {
        const Cell *cell;
        float x, y;
    };
    Spot spotAt(int chart, const Vec3 &p) const;
    // The bilinear weights of the corners that have sites, never 0; 0 for the others. Returns their sum.
    float weigh(const Spot &spot, float (&weight)[4]) const;
    // Sets each hidden texel to the mean of the known texels around it. `light` has an item for every texel.
    void fill(std::vector<Rgb> &light) const;

private:
    std::vector<uint16_t> ring; // of a hidden texel: its distance from known ones, 1 ..; else 0
    void divide(int block);
    // Finds the visible places of the texels. Returns, for each of a texel's four places, how far below the
    // start of its ray it lies.
    std::vector<float> see(const Regions &regions, const RayTree &tree, Workers &workers);
    void makeSites(const Regions &regions, const std::vector<float> &drops);
    void orderHidden();
};

} // namespace odraz::radiosity
