// What a solution is compared with: light at places of a model, gathered by rays alone. They are drawn at
// random by the cosine law, which nothing that ships does.
#pragma once

#include "tools/radiosity/bake.h"

namespace odraz {

struct Probe {
    int chart;
    Vec3 p;
    Rgb light;   // what arrives there: irradiance / pi
    bool inside; // of a solid: nobody sees it
};

// Places spread evenly over what can be seen of a solved model, `count` about.
std::vector<Probe> placeProbes(const Model &model, int count);

// Fills the probes' light: rays by the cosine law, `side` x `side` a probe, that bring the radiosity of what
// they meet in `bake`; and what lamps give them, by as many shadow rays to every one. Drops those that lie
// inside.
void gatherProbes(const Bake &bake, std::vector<Probe> &probes, int side, Workers &workers);
void dropInside(std::vector<Probe> &probes);

// Form factor of a facet from a place, with what stands between, by side x side shadow rays.
double facetFormFactor(const Model &model, const Scene &scene, int facet, const Chart &from, Vec3 p, int side,
                       uint32_t seed);

// What rays by the cosine law from a place of a chart meet, side x side of them, one in each cell of a grid:
// calls met for every one that meets a front, or nothing (chart -1). Returns how many met a back.
int castFan(const Scene &scene, const Chart &from, Vec3 p, int side, uint32_t seed,
            const std::function<void(int chart, Vec3 at, Vec3 d)> &met);

// Form factors by rays, `side` x `side` a patch.
RowFinder rowsByRays(int side);

// The light of a solution at a probe.
Rgb lightAtProbe(const Model &model, float *const light[3], const Probe &probe);

// Root mean square of the differences over that of the probes' light, in percent.
double rmsPercent(const Model &model, float *const light[3], const std::vector<Probe> &probes);

} // namespace odraz
