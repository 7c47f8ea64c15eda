// Where a mesh keeps its light: cells over its charts and texels at their corners (trace/scene/lightmap.h),
// and sites, at which rays are sent out.
//
// A texel is looked at from up to four places around it, a quarter of its cells' sides away, as in
// radiosity/visible.h; those that lie on no triangle or inside something closed do not count. A chart of one
// cell is a site, with all its places; of larger ones every texel is.
#pragma once

#include "tools/radiosity/ray_tree.h"
#include "tools/radiosity/regions.h"

#include "base/parallel.h"

#include <cstdint>
#include <vector>

namespace odraz {

// The triangles of a mesh as they are traced.
std::vector<RayTree::Corners> cornersOf(const Mesh &mesh);

struct LightGrid {
    static constexpr uint32_t kNone = 0xffffffff;
    struct Place {
        Vec3 p; // just off the surface
        int texel;
    };
    struct Site {
        uint32_t firstPlace;
        uint16_t places; // 1 ..
        bool small;      // it stands for all of its chart
        int chart;
        float size; // the side of a square of its area
    };
    std::vector<Chart> &charts;
    std::vector<Cell> cells;
    std::vector<Texel> texels;
    std::vector<uint32_t> siteOf; // of each texel; kNone: nothing of it can be seen
    std::vector<Site> sites;
    std::vector<Place> places; // of a site, and of a texel, one after the other
    std::vector<int> tied;     // hidden texels, in the order in which they are filled

    // Numbers the cells and texels of the charts, which stay the caller's.
    LightGrid(Regions &regions, const RayTree &tree, Workers &workers);

    Vec3 at(const Texel &t) const;
    // The cell at a place of a chart, and where in it, 0 .. 1.
    struct Spot {
        const Cell *cell;
        float x, y;
    };
    Spot spotAt(int chart, const Vec3 &p) const;
    // Gives hidden texels the mean of those around them that are known; `light` of all texels.
    void fill(std::vector<Rgb> &light) const;

private:
    std::vector<uint16_t> ring; // of a hidden texel: how far from what is known, 1 ..; else 0
    void divide();
    // What can be seen of the texels, and how far below where they are looked for their four places are.
    std::vector<float> see(const Regions &regions, const RayTree &tree, Workers &workers);
    void makeSites(const Regions &regions, const std::vector<float> &drops);
    void orderHidden();
};

} // namespace odraz
