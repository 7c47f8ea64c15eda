// Light from the sky and from other surfaces, by rays from every site: the rays give rows of form factors,
// and the radiosity system is solved with them.
//
// A site casts rays by the cosine law. The sites that they hit are its row, with an equal share for each hit,
// like a hemicube whose pixels have equal weights; rays that hit nothing see the sky. The system is E = S + F
// rho (D + E), where E is the light that arrives, D direct light and S the sky's. Directions form a spiral
// (Vogel, 1979: the golden angle on a disc), rotated differently at each site. If a chart has several sites
// around the point that a ray hits, one of them is chosen at random, near ones more often.
//
// In the end neighbouring sites share light where the split-sphere model (Ward, Rubinstein and Clear, "A Ray
// Tracing Solution for Diffuse Interreflection", 1988) predicts little change: over large distances where
// visible surfaces are far away, not at all where surfaces touch.
#pragma once

#include "tools/radiosity/rays/light_grid.h"
#include "tools/radiosity/rays/near_sites.h"
#include "tools/radiosity/read/surroundings.h"
#include "tools/radiosity/solution/solution.h"

#include <functional>
#include <map>
#include <string>

namespace odraz::radiosity {

// The predicted change of light up to which sites share it.
inline constexpr float kShared = 0.2f;

class RaySystem {
public:
    static constexpr uint32_t kDark = 0xffffffff;               // the ray hits the sky, a back, or no site
    static constexpr uint16_t kLeastRays = 32, kMostRays = 512; // rays of one site
    static constexpr double kAllRays = 24e6;                    // rays of all sites

    RaySystem(const LightGrid &grid, const Surroundings &surroundings, Workers &workers);

    // For each site: the mean of its texels' values over the sample points that count; its reflectance.
    std::vector<Rgb> meansOfPoints(const std::vector<Rgb> &texels) const;
    std::vector<Rgb> reflectance(const Solution &solution) const;

    // Sets each site's number of rays. A site keeps its row if its number does not change; others repeat
    // their old row until the new one is found. Returns the number of rows to find.
    size_t setRays(const std::vector<uint16_t> &rays);
    size_t rays(size_t site) const { return firstOf[site + 1] - firstOf[site]; }
    // Finds the missing rows of sites first .. end.
    void findRows(size_t first, size_t end);

    // The number of rays that each site needs for a relative error of `error` after sharing, estimated from
    // the light along its present rays: powers of two, kLeastRays .. kMostRays, at most kAllRays in total.
    std::vector<uint16_t> raysFor(const std::vector<Rgb> &direct, const std::vector<Rgb> &reflects,
                                  float error, float share) const;

    // Solves for `arrives`, from the direct light and the reflectance of the sites, in at most `sweeps`
    // sweeps. Calls afterSweep(residual) after each one, and stops if it returns false. With `bounces` a
    // sweep is one bounce; without, new values are used at once. Returns the number of sweeps.
    int solve(const std::vector<Rgb> &direct, const std::vector<Rgb> &reflects, bool bounces, float residual,
              int sweeps, const std::function<bool(float residual)> &afterSweep);

    // The final gather: `rays` more rays from every site collect the interpolated light of the texels.
    void finalGather(int first, int end, int rays, const Solution &soFar);

    // The light that arrives at all visible texels, without direct light: the light of the sites, which
    // neighbours share where it changes by less than `share`.
    std::vector<Rgb> atTexels(float share) const;

    // The same for `columns` values of every site, a multiple of 8: adds values[site][columns] to
    // texels[texel][columns], which must be zero.
    void atTexels(float share, const float *values, int columns, float *texels) const;

    // Calls visit(site, direction) for every ray that hits nothing: light from outside arrives along it.
    // Several threads call it; all calls for a site are made by one thread.
    void alongOpenRays(const std::function<void(size_t site, const Vec3 &direction)> &visit) const;

    // Writes and reads `refined` and the rows found so far, as arrays (arrays.h); false if they do not fit
    // the grid.
    std::string saved() const;
    bool restore(std::string_view from);

    std::vector<Rgb> arrives; // light at every site
    // The emission of charts, if these rays find it; empty if it counts as direct light
    std::vector<Rgb> emits;
    std::vector<uint64_t> firstOf; // index of each site's row in `rows`, and the end of the list
    std::vector<uint32_t> rows;    // the sites that were hit
    std::vector<uint8_t> found;    // for each site: whether its row is found
    bool refined = false;          // the number of rays of each site is final
    bool findsExcluded = true;     // findRows() also sets `excluded`
    std::vector<Rgb> sky;          // the sky's light at each site
    std::vector<float> skySquare;  // for each site: mean squared luminance of the sky along its rays
    std::vector<float> reach;      // for each site: harmonic mean of the distances that its rays travel
    // For each site: a bit for each sample point, set if the point does not count. Many rays of such a point
    // hit backs, and hardly any rays of the site's other points do: the point lies behind or under something
    // thin that cuts through the surface.
    std::vector<uint16_t> excluded;

private:
    NearSites near;
    const LightGrid &grid;
    const Surroundings &surroundings;
    Workers &workers;
    Rgb emitted(size_t site) const { return emits.empty() ? Rgb{} : emits[(size_t)grid.sites[site].chart]; }
    // The directions for each number of rays that these sites have.
    std::map<size_t, std::vector<Vec3>> spiralsOf(size_t first, size_t end) const;
    template <class OnHit>
    void cast(size_t site, int count, const std::vector<Vec3> &spiral, const OnHit &onHit) const;
    void findRow(size_t site, const std::vector<Vec3> &spiral);
    std::vector<Rgb> sourceLight() const;
    struct alignas(16) Lanes { // red, green, blue, 0
        __m128 v;
    };
    Rgb gather(size_t site, const std::vector<Lanes> &radiosity) const;
    // Calls visit(other, weight) for all sites that share light with the point p of a site.
    template <class Visit>
    void forNeighbours(uint32_t site, const Vec3 &p, float share, const Visit &visit) const;
    // The site at a point of a chart, chosen at random among the nearest; kDark if there is none.
    uint32_t siteAt(int chart, const Vec3 &p, uint32_t random) const;
};

struct SolveTask;
// Solves a model by rays from every element: fills task.solution and task.report. Throws std::runtime_error.
void solveByRays(SolveTask &task);

} // namespace odraz::radiosity
