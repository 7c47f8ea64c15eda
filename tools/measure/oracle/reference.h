// References for a solution between patches: light at places of a model, gathered by rays.
#pragma once

#include "tools/measure/oracle/model_rays.h"
#include "tools/radiosity/solve/solve.h"

namespace odraz {

struct Probe {
    int chart;
    Vec3 p;
    Rgb light;   // what arrives there: irradiance / pi
    bool inside; // inside a solid: nobody sees it
};

// About `count` places, spread evenly over the visible surfaces of a solved model.
std::vector<Probe> placeProbes(const Model &model, int count);

// Finds the probes' light. Each probe sends side x side rays, which bring the radiosity of what they hit in a
// solution between patches; as many shadow rays go to each lamp. Drops the probes that lie inside a solid.
void traceProbes(const radiosity::Solved &solved, std::vector<Probe> &probes, int side, Workers &workers);
// Whether a place counts as inside, given how many of side x side rays hit backs.
bool insideBy(int backs, int side);
void dropInside(std::vector<Probe> &probes);

// The solution's light at a probe.
Rgb lightAtProbe(const Model &model, float *const light[3], const Probe &probe);

// The root mean square of the differences, as a percentage of that of the probes' light.
double rmsPercent(const Model &model, float *const light[3], const std::vector<Probe> &probes);

} // namespace odraz
