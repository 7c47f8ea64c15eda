// Solves many lights at once between sites: their rows of rays (rays/ray_system.h) as form factors of the
// film's system (radiosity/solve.h), which takes any number of right-hand sides.
#pragma once

#include "radiosity/solve.h"
#include "tools/engine/heap_arena.h"
#include "tools/radiosity/rays/ray_system.h"

#include <vector>

namespace odraz::radiosity {

// The columns are red, green and blue of each light: 3 light + channel.
class ColumnSystem {
public:
    // `lights` lights on sites that reflect this. Throws std::runtime_error if memory is short.
    ColumnSystem(const RaySystem &rays, const std::vector<Rgb> &reflects, int lights, size_t memory);
    ColumnSystem(const ColumnSystem &) = delete;

    int columns() const { return system.columns; } // a multiple of kSolveBlock
    // A site's direct light, irradiance / pi, of all columns: to be set before solve(). What rays bring
    // (`source`) is shared between neighbours later, so it is kept apart.
    float *source(size_t site) { return &sources[site * (size_t)system.columns]; }
    float *direct(size_t site) { return system.direct + site * (size_t)system.columns; }

    // Solves until a sweep changes less than the residual. Returns the number of sweeps.
    int solve(float residual, Workers &workers);

    // After solve(): what arrives along a site's rays, without direct light; and what it reflects, as
    // radiance.
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
