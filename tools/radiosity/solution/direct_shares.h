// Direct light, kept so that it need not be gathered again for other lamps' power: for every material that
// emits, the light that each texel gets where that material's radiance is 1; and the light from outside.
#pragma once

#include "tools/radiosity/solution/solution.h"

#include <string>
#include <string_view>
#include <vector>

namespace odraz::radiosity {

struct DirectShares {
    // With more materials that emit, direct light is gathered again, which costs less than keeping it.
    static constexpr size_t kMost = 16;

    std::vector<int> emitters;              // the materials, ascending
    std::vector<std::vector<float>> shares; // of each of them, at each texel: irradiance / pi; none if `seen`
    std::vector<Rgb> outside;               // at each texel, from sky, suns and balls; empty: none
    bool seen = false;                      // form factors bring the lamps' light: no shares are needed

    // The direct light of `texels` texels where the materials emit this.
    std::vector<Rgb> light(const std::vector<Rgb> &emits, size_t texels) const;

    void save(std::string &to) const;
    // False if a material is not below `materials`, or the file ends.
    bool restore(std::string_view from, size_t &at, size_t materials);
    bool fits(size_t texels) const;
};

} // namespace odraz::radiosity
