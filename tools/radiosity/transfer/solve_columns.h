// Solves for many lights at once: converts the sites' rows of rays (rays/ray_system.h) to form factors of the
// film's system (radiosity/solve.h), which has any number of right-hand sides.
#pragma once

#include "radiosity/solve.h"
#include "tools/engine/heap_arena.h"
#include "tools/radiosity/rays/ray_system.h"

#include <vector>

namespace odraz::radiosity {

// The columns are red, green and blue of each light: 3 light + channel.
class ColumnSystem {
public:
    // `reflects` is the sites' reflectance. Throws std::runtime_error if memory is short.
    ColumnSystem(const RaySystem &rays, const std::vector<Rgb> &reflects, int lights, size_t memory);
    ColumnSystem(const ColumnSystem &) = delete;

    int columns() const { return system.columns; } // a multiple of kSolveBlock
    // A site's direct light, irradiance / pi, in all columns. Set it before solve(): in `source` the light
    // that rays find, which is later shared between neighbours, in `direct` the rest.
    float *source(size_t site) { return &sources[site * (size_t)system.columns]; }
    float *direct(size_t site) { return system.direct + site * (size_t)system.columns; }

    // Solves until a sweep changes the light by less than the residual.
    void solve(float residual, Workers &workers);

    // After solve(): the light that arrives along the sites' rays, without `direct`; and the light that a
    // site reflects, as radiance.
    const float *arrives() const { return sources.data(); }
    const float *reflected(size_t site) const { return system.radiosity + site * (size_t)system.columns; }

    static size_t bytesFor(size_t sites, size_t links, int lights);

private:
    HeapArena memory;
    std::vector<Link> links;
    std::vector<Row> rows;
    FormFactors factors = {};
    System system = {};
    std::vector<float> sources;
};

} // namespace odraz::radiosity
