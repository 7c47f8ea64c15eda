// Small charts that share hemicubes: where a model has no large polygons, neighbours that face about the same
// way have one patch together.
#pragma once

#include "radiosity/elements.h"
#include "radiosity/form_factor.h"

#include <functional>
#include <vector>

namespace odraz {

class Clusters {
public:
    // Replaces the patches of the charts of a divided model that are smaller than half of `patch` by
    // shared ones. `group` tells charts apart that must not share. Takes memory for the patches.
    Clusters(Model &model, double patch, const std::function<int(int chart)> &group, Arena &arena);

    // Light of shared patches is one value for all their texels: makes it pass smoothly from one to the next,
    // by how near they are and how alike they face (Ward, Rubinstein and Clear, "A Ray Tracing Solution for
    // Diffuse Interreflection", SIGGRAPH 1988).
    void smooth(const Model &model, const FormFactors &factors, float *const planes[3]) const;

    int count() const { return (int)members.size(); }

private:
    double side;
    int firstPatch = 0;
    std::vector<std::vector<int>> members; // charts
    std::vector<int> clusterOf;            // of each chart; -1: none
};

} // namespace odraz
