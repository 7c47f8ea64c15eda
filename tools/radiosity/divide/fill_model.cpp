// Turns regions into a model for the film's stages, and into a scene for rays.
#include "tools/radiosity/divide/regions.h"

#include <algorithm>

namespace odraz::radiosity {

void poseFacets(const Model &model, Scene &scene) {
    for (int i = 0; i < model.facetCount; ++i) {
        const Facet &f = model.facets[i];
        const Chart &c = model.charts[f.chart];
        Shape s = model.shapeOf(i);
        if (f.triangle()) {
            Vec3 corner = f.corner(c, 0);
            s = triangle(corner, f.corner(c, 1) - corner, f.corner(c, 2) - corner, c.n);
        }
        s.chart = f.chart;
        s.material = 0;
        scene.add(s);
    }
}

void fillModel(Model &model, const Regions &regions) {
    if (regions.charts.size() > (size_t)kMaxCharts || regions.facets.size() > (size_t)kMaxFacets)
        throw ModelError("more than " + std::to_string(kMaxFacets) +
                         " polygons are left after joining those in one plane: solve by rays, without "
                         "--hemicube, --patch, "
                         "--adaptive and --direct");
    std::copy(regions.charts.begin(), regions.charts.end(), model.charts);
    std::copy(regions.facets.begin(), regions.facets.end(), model.facets);
    model.chartCount = (int)regions.charts.size(), model.facetCount = (int)regions.facets.size();
}

} // namespace odraz::radiosity
