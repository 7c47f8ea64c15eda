// Values of sites: means over their places.
#pragma once

#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/solution/solution.h"

namespace odraz::radiosity {

// If more than this share of a model's area emits, rays find that light, and no shadow rays are sent to it.
inline constexpr double kLargeLamps = 0.25;
// The change of light up to which sites share it.
inline constexpr float kShared = 0.2f;

// The direct light of the sites, from that of the texels: means over the places that count (`behind` as in
// RaySystem).
std::vector<Rgb> meansOfSites(const LightGrid &grid, const std::vector<uint16_t> &behind,
                              const std::vector<Rgb> &texels);

// The reflectance of the sites.
std::vector<Rgb> reflectanceOfSites(const LightGrid &grid, const Solution &solution);

} // namespace odraz::radiosity
