// Light from the sky and from other surfaces, by rays from every site of a mesh.
//
// A site sends out so many rays by the cosine law; what they meet is its row: sites, each with an equal
// share. That is a hemicube whose pixels count alike, and the sky is seen by the same rays. Rows are kept,
// and the system solved with them: E = S + F rho (D + E), where D is direct light and S the sky's. Directions
// are a spiral's (Vogel, 1979: the golden angle on a disc) turned otherwise at every site. Where a ray meets
// a chart of several sites it counts to one of those around, by how near they are, at random.
//
// In the end light passes smoothly from site to site where the split-sphere model (Ward, Rubinstein and
// Clear, "A Ray Tracing Solution for Diffuse Interreflection", 1988) says that it changes little: neighbours
// share their rays, most where everything is far away, none where things touch.
#pragma once

#include "tools/radiosity/light_grid.h"
#include "tools/radiosity/near_sites.h"
#include "tools/radiosity/surroundings.h"

#include <functional>
#include <string>

namespace odraz {

class Gather {
public:
    static constexpr uint32_t kDark = 0xffffffff; // the sky, a back, or what has no light
    static constexpr uint16_t kLeastRays = 32, kMostRays = 512;
    static constexpr double kAllRays = 24e6;

    Gather(const Regions &regions, const LightGrid &grid, const RayTree &tree, const Surroundings &around);

    // Makes room for so many rays from every site; those that had as many keep their rows, the others have
    // what they had, over and over, until theirs are found. Returns how many are to be found.
    size_t setRays(const std::vector<uint16_t> &rays);
    size_t rays(size_t site) const { return firstOf[site + 1] - firstOf[site]; }
    // Finds those of sites first .. end.
    void findRows(size_t first, size_t end, Workers &workers);

    // How many rays every site should have, by what the present ones bring: so that light is off by `error`
    // of it, with what neighbours share; kLeastRays to kMostRays, powers of two, kAllRays of them all in all.
    std::vector<uint16_t> raysFor(const std::vector<Rgb> &direct, const std::vector<Rgb> &reflects,
                                  float error, float share, Workers &workers) const;

    // Solves for what arrives, from direct light at the sites and what they reflect. `sweeps` at most;
    // told(residual) is called after every one, and ends it by returning false. With `bounces` a sweep is one
    // bounce, else new values are used at once. Returns how many sweeps it took.
    int solve(const std::vector<Rgb> &direct, const std::vector<Rgb> &reflects, bool bounces, float residual,
              int sweeps, Workers &workers, const std::function<bool(float residual)> &told);

    // What arrives once more, by `rays` from every site, in the light of all texels: final gathering.
    void gatherFinal(int rays, const std::vector<Rgb> &texels, const std::function<Rgb(int cell)> &reflects,
                     Workers &workers);

    // What arrives at all texels that can be seen, without direct light: what sites have, shared with their
    // neighbours where their light would be off by less than `share` of it.
    std::vector<Rgb> atTexels(float share, Workers &workers) const;

    // What rows there are, as arrays of a file; false where they do not suit the grid.
    void save(std::string &to) const;
    bool restore(const std::string &from, size_t &at);

    std::vector<Rgb> arrives; // at every site
    // What charts emit that rays are to find; empty: nothing, lamps are direct light
    std::vector<Rgb> emits;
    std::vector<uint64_t> firstOf; // of every site's in `rows`, and their end
    std::vector<uint32_t> rows;    // sites
    std::vector<uint8_t> found;    // whether a site's is there
    bool judges = true;            // whether finding rows finds what lies behind, too
    std::vector<Rgb> sky;          // of every site
    std::vector<float> skySquare;  // mean of its brightness, squared
    std::vector<float> reach;      // the harmonic mean of the distances of what it sees
    // A bit for each of a site's places that does not count: it sees many backs, others of the site none. It
    // lies behind something thin that cuts through, or under it.
    std::vector<uint16_t> behind;

private:
    NearSites near;
    const Regions &regions;
    const LightGrid &grid;
    const RayTree &tree;
    const Surroundings &around;
    Rgb emitted(size_t site) const { return emits.empty() ? Rgb{} : emits[(size_t)grid.sites[site].chart]; }
    template <class Met>
    void cast(size_t site, int count, const std::vector<Vec3> &spiral, const Met &met) const;
    void findRow(size_t site, const std::vector<Vec3> &spiral);
    // visit(other, weight) for all sites whose light counts at a place of one
    template <class Visit>
    void neighbours(uint32_t own, const Vec3 &p, float share, const NearSites &near,
                    const Visit &visit) const;
    uint32_t siteAt(int chart, const Vec3 &p, uint32_t random) const;
};

} // namespace odraz
