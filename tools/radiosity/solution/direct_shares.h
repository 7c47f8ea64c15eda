// Direct light, kept so that it need not be gathered again when the lamps' power changes: for every material
// that emits, the light that each texel gets if that material's radiance is 1; and the light from outside.
#pragma once

#include "tools/radiosity/solution/solution.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace odraz::radiosity {

struct DirectShares {
    // With more emitting materials, gathering direct light again costs less than keeping it.
    static constexpr size_t kMost = 16;

    std::vector<int> emitters;              // the materials, ascending
    std::vector<std::vector<float>> shares; // of each, at each texel: irradiance / pi; empty if `seen`
    std::vector<Rgb> outside;               // at each texel, from sky, suns and balls; empty: none
    bool seen = false;                      // form factors include the lamps' light, so no shares are needed

    // Finds the shares of these materials. `gather` returns the light of the texels for the radiances of all
    // materials up to the last of these. It is called for three at a time, as red, green and blue.
    void find(const std::function<std::vector<Rgb>(const std::vector<Rgb> &ofMaterial)> &gather);
    // The direct light of `texels` texels for these emissions, one for each material.
    std::vector<Rgb> light(const std::vector<Rgb> &emits, size_t texels) const;

    void save(std::string &to) const;
    // False if an index of a material is not below `materials`, or if the data is too short.
    bool restore(std::string_view from, size_t &at, size_t materials);
    bool fits(size_t texels) const;
};

} // namespace odraz::radiosity
