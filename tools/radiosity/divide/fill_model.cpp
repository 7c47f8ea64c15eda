#include "tools/radiosity/divide/regions.h"

#include <algorithm>

namespace odraz::radiosity {

void fillModel(Model &model, const Regions &regions) {
    if (regions.charts.size() > (size_t)kMaxCharts || regions.facets.size() > (size_t)kMaxFacets)
        throw ModelError("more than " + std::to_string(kMaxFacets) +
                         " polygons are left after joining those in one plane: solve by rays, without "
                         "--hemicube, --patch and --direct");
    std::copy(regions.charts.begin(), regions.charts.end(), model.charts);
    std::copy(regions.facets.begin(), regions.facets.end(), model.facets);
    model.chartCount = (int)regions.charts.size(), model.facetCount = (int)regions.facets.size();
}

} // namespace odraz::radiosity
